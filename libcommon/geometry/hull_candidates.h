#pragma once

#include <vector>

#include "mesh/types.h"

namespace partwise {

/// Indices, ascending, of the points that may lie on the convex hull of all: those not clearly inside the
/// hull of the extreme points in 26 directions. Spares exact predicates most of the points of a large set.
///
/// Keeps every point of the hull's surface; of a small, flat or needle-like set it keeps all.
std::vector<int> hull_candidates(const Points& points);

}  // namespace partwise
