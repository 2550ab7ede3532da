#pragma once

#include "mapping/domains.h"

namespace partwise {

/// Closes every part by caps and wraps its convex hull around it ([Wu11] 4.2, METHOD section 2).
/// \throws InputError naming the first part that is flat or has fewer than 4 distinct points.
HulledModel build_hulls(const SegmentedModel& model);

}  // namespace partwise
