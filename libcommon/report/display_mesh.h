#pragma once

#include <vector>

#include "mesh/tri_mesh.h"

namespace partwise::report {

/// A mesh with fewer facets, to look at: facets over some of the original's vertices, none of them moved.
///
/// What the original knows of a vertex or facet, the shown one has by its number there; so all states of a
/// model, which share its connectivity, are shown with the same facets.
struct DisplayMesh {
  std::vector<int> vertices;  ///< per shown vertex: vertex of the original, ascending
  Facets facets;              ///< of shown vertices
  std::vector<int> origin;    ///< per shown facet: facet of the original in the same part, ascending

  bool is_decimated(const TriMesh& original) const {
    return static_cast<int>(facets.size()) < original.facet_count();
  }
};

/// Collapses edges by quadric error (Garland and Heckbert 1997; OpenMesh) until about `most` facets are left.
/// Vertices on boundaries between parts and of the mesh stay, so the result may have more. A mesh that small
/// is shown as it is.
/// \param labels per facet: its part \pre 0 < most
DisplayMesh display_mesh(const TriMesh& mesh, const std::vector<int>& labels, int most);

}  // namespace partwise::report
