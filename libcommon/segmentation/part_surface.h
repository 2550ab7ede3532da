#pragma once

#include <vector>

#include "mesh/tri_mesh.h"

namespace partwise {

/// One part as an open mesh of its own, without caps: vertices and facets by ascending index in the model.
struct PartSurface {
  TriMesh mesh;
  std::vector<int> model_vertex;  ///< per vertex of `mesh`
  std::vector<int> model_facet;   ///< per facet of `mesh`
};

/// \param labels per facet, the part it belongs to \pre the part has facets, and is not pinched
PartSurface part_surface(const TriMesh& mesh, const std::vector<int>& labels, int part);

}  // namespace partwise
