#pragma once

#include "mapping/star_hull.h"
#include "mapping/untangle.h"

namespace partwise {

/// Undoes the folds of a map onto a hull as far as it can, see untangle.
///
/// \pre the arguments are those of relax_on_hull, but `start` may have folds
UntangledMap untangle_on_hull(const TriMesh& mesh, const StarHull& hull, const Points& start,
                              const std::vector<bool>& fixed);

}  // namespace partwise
