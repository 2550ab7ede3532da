#pragma once

#include "mesh/tri_mesh.h"

namespace partwise {

struct UntangledDirections {
  Points directions;     ///< per vertex, unit
  int folds_before = 0;  ///< facets not positively oriented, seen from the centre
  int folds_after = 0;
};

/// Undoes the folds of a map onto the sphere of directions as far as it can: the vertices around folded
/// facets move over the sphere, one at a time, down the regularised energy of Garanzha et al. 2021; the rest
/// and the fixed vertices stay to the bit.
///
/// A facet is measured against its own shape in the size that its surroundings have on the sphere at the
/// start (isotropic, smoothed, frozen): the sphere may show one place of the surface a thousand times smaller
/// than another, and a reference that follows the map itself lets errors grow. \param start one per vertex,
/// of any length > 0 \param fixed one per vertex
UntangledDirections untangle_on_sphere(const TriMesh& mesh, const Points& start,
                                       const std::vector<bool>& fixed);

}  // namespace partwise
