#pragma once

#include <vector>

#include "mesh/tri_mesh.h"

namespace partwise {

/// Some facets of a model as an open mesh of their own: vertices and facets by ascending index in the model.
struct Submesh {
  TriMesh mesh;
  std::vector<int> model_vertex;  ///< per vertex of `mesh`
  std::vector<int> model_facet;   ///< per facet of `mesh`
};

/// \param inside per facet of `mesh`
/// \pre some facet is inside, and they touch along edges only
Submesh extract_submesh(const TriMesh& mesh, const std::vector<bool>& inside);

/// Which facets bear a label, as `inside` above.
std::vector<bool> facets_labelled(const std::vector<int>& labels, int label);

}  // namespace partwise
