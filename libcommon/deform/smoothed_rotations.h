#pragma once

#include <vector>

#include "mesh/tri_mesh.h"

namespace partwise {

/// Rotations that change slowly from facet to facet and are near the given ones: their mean over a
/// neighbourhood of about `reach`, found by diffusing the matrices over the surface; what is left is turned
/// into rotations again.
/// \param rotations one per facet; those that are not `known` do not count
/// \param reach in the units of the mesh, > 0
std::vector<Eigen::Matrix3d> smoothed_rotations(const TriMesh& mesh,
                                                const std::vector<Eigen::Matrix3d>& rotations,
                                                const std::vector<bool>& known, double reach);

}  // namespace partwise
