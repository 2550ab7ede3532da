#pragma once

#include <vector>

#include "mesh/tri_mesh.h"

namespace partwise {

/// An order of a mesh's vertices and facets that its shape decides, not their numbers: the same for a mesh
/// whose vertices and facets are numbered otherwise, and which is turned, moved or scaled.
struct CanonicalOrder {
  std::vector<int> vertices;  ///< vertex of the mesh at each place
  TriMesh mesh;               ///< the mesh renumbered: vertex i is vertices[i]
};

/// From the half-edge farthest out (which of two that are mirror images of each other, their orientation
/// decides), facets are visited across their edges. Shapes that are turned into themselves by a rotation have
/// several such orders; there the mesh's own numbers choose.
CanonicalOrder canonical_order(const TriMesh& mesh);

}  // namespace partwise
