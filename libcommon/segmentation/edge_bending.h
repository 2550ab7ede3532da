#pragma once

#include "mesh/tri_mesh.h"

namespace partwise {

/// Radius of the balls over which the crease field sums, over the diagonal.
inline constexpr double kCreaseRadius = 0.014;

struct EdgeEnds {
  int from;
  int to;
};

/// The vertices of edge `edge` (OpenMesh index).
EdgeEnds edge_ends(const TriMesh& mesh, int edge);

/// Signed dihedral angle in radians: positive at a convex edge, 0 on a flat one and on the mesh's boundary.
/// \param normals unit, per facet
double dihedral_angle(const TriMesh& mesh, const Points& normals, int edge);

}  // namespace partwise
