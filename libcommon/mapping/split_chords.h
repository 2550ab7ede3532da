#pragma once

#include "mesh/tri_mesh.h"

namespace partwise {

/// A mesh with the edges split that would leave a map no freedom, and how to read it as the original.
struct SplitMesh {
  TriMesh mesh;                                 ///< the first vertices are the original's, in its order
  std::vector<std::array<int, 2>> split_edges;  ///< per added vertex: the edge of the original it halves
};

/// Halves every edge between two fixed vertices that is not in `kept`: a facet with three fixed corners
/// cannot turn over back by itself. Facets with several such edges are cut into as many pieces as needed.
///
/// \pre fixed has one entry per vertex
/// \param kept says whether the edge between two fixed vertices must stay whole (an edge of a boundary loop)
SplitMesh split_chords(const TriMesh& mesh, const std::vector<bool>& fixed,
                       const std::vector<std::array<int, 2>>& kept);

}  // namespace partwise
