#pragma once

#include "mapping/alignment.h"
#include "mapping/star_hull.h"

namespace partwise {

/// The linear map about the hulls' centres that, followed by central projection onto the target's hull,
/// brings the matched points closest to their goals.
///
/// Several are tried: rotations between the one the points alone ask for, which for a thin part says little
/// of the turn about its axis, and `upright`; each with extents matched, and drawn further towards the
/// points. The best is turned on as long as that helps. All keep orientation, so a one-to-one map stays
/// one-to-one. Exact for a similar copy when `upright` is. Everything is relative to the two centres. \pre
/// both sets of hull points span space
Eigen::Matrix3d align_to_hull(const MatchedPoints& matched, const Points& source_hull,
                              const Points& target_hull, const StarHull& hull,
                              const Eigen::Matrix3d& upright);

}  // namespace partwise
