#pragma once

#include "mesh/tri_mesh.h"

namespace partwise {

/// Per vertex: how far it stands out of the surface smoothed by heat flow, along its normal and over the
/// radius of smoothing, at radii of 1, 2 and 4 % of the diagonal (x, y, z). About half the radius times the
/// sum of the principal curvatures, averaged over the radius; positive on ridges and tips.
///
/// Moving, turning and scaling the mesh changes nothing. Smoothing is one implicit step of the Laplacian of
/// cotangents, so it does not depend on how finely the surface is meshed. Where normals cancel it is 0.
std::vector<Vec3> relief(const TriMesh& mesh);

}  // namespace partwise
