#pragma once

#include "mapping/untangle.h"

namespace partwise {

/// Undoes the folds of a map onto the sphere of directions as far as it can, see untangle.
///
/// A facet is measured against its own shape in the size that its surroundings have on the sphere at the
/// start (isotropic, smoothed, frozen): the sphere may show one place of the surface a thousand times smaller
/// than another, and a reference that follows the map itself lets errors grow. \param start one per vertex,
/// of any length > 0 \param fixed one per vertex
UntangledMap untangle_on_sphere(const TriMesh& mesh, const Points& start, const std::vector<bool>& fixed);

}  // namespace partwise
