#pragma once

#include "mesh/types.h"

namespace partwise {

/// Exact sign (-1, 0, 1) of det(b - a, c - a, d - a): 1 when a, b, c turn counterclockwise seen from d.
///
/// A facet (p1, p2, p3) is positively oriented as seen from an interior point o of its hull when
/// orientation_sign(o, p1, p2, p3) is 1. Unlike a determinant in floating point it is never wrong, so
/// certificates rest on it. \pre finite coordinates
int orientation_sign(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace partwise
