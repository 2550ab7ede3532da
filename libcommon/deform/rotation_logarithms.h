#pragma once

#include <vector>

#include "mesh/tri_mesh.h"

namespace partwise {

/// The rotation vector of `rotation`: its axis times its angle in 0 .. pi.
Vec3 rotation_logarithm(const Eigen::Matrix3d& rotation);

/// The rotation about `logarithm` by its length in radians.
Eigen::Matrix3d rotation_exponential(const Vec3& logarithm);

/// The rotation vector nearest to `near` among those of one rotation: same axis, other turns.
Vec3 nearest_logarithm(const Vec3& logarithm, const Vec3& near);

/// Rotation vectors of the facets' rotations that go with each other: a facet takes the number of turns that
/// brings it nearest to its neighbour, so that what is turned by more than half a turn bit by bit comes back
/// the way it went.
///
/// Grows over each component from the facet turned least, always across the edge where the rotation changes
/// least; so facets with a rotation of their own (slivers, folds) do not lead the others astray.
/// \param rotations one per facet; for facets that are not `known`, anything
/// \param certain facets turned by less than this, in radians, are taken to have no further turn: it grows
/// from all of them \return one per facet; those not known are reached last
Points rotation_logarithms(const TriMesh& mesh, const std::vector<Eigen::Matrix3d>& rotations,
                           const std::vector<bool>& known, double certain = 0);

}  // namespace partwise
