#pragma once

#include "mesh/types.h"

namespace partwise {

/// Half the cotangent of the angle between two edges, a facet's share of the Laplacian's weight of the edge
/// that faces them, within [0.01, 100] so that every weight is positive and finite; half a cotangent is 0.29
/// in an equilateral facet. An angle of nothing has the largest.
double bounded_half_cotangent(const Vec3& a, const Vec3& b);

}  // namespace partwise
