#pragma once

#include <vector>

#include "mesh/tri_mesh.h"

namespace partwise {

/// Shortest ways along edges from a set of vertices.
struct EdgeDistances {
  std::vector<double> distance;  ///< per vertex, in units of the model; infinite where there is no way
  std::vector<int> previous;  ///< per vertex: the one before it on its way; -1 at the start and out of reach

  /// Vertices from `vertex` back to the start.
  std::vector<int> way_back(int vertex) const;

  /// The vertex in reach that is farthest away, of equal ones the first.
  int farthest() const;
};

/// \param may_pass per vertex: whether ways may lead there; empty for everywhere. Of equally short ways the
/// one through the vertex reached first counts.
EdgeDistances edge_distances(const TriMesh& mesh, const std::vector<int>& starts,
                             const std::vector<bool>& may_pass);

}  // namespace partwise
