#pragma once

#include <vector>

#include "mapping/ring_mesh.h"

namespace partwise {

/// A vertex merged into the first of its ring.
struct Collapse {
  int vertex;
  RingMesh::Ring ring;
};

/// Collapses a closed genus-0 mesh down to a tetrahedron, short edges and low degrees first, and leaves
/// `rings` there.
///
/// \pre rings is RingMesh(mesh)
/// \return the collapses in their order; restoring them in reverse order gives the mesh back
/// \throws InputError when no edge can be collapsed before four vertices are left: the mesh is no sphere
std::vector<Collapse> collapse_to_tetrahedron(const TriMesh& mesh, RingMesh& rings);

}  // namespace partwise
