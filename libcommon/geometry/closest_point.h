#pragma once

#include "mesh/types.h"

namespace partwise {

/// Barycentric coordinates (non-negative, sum 1) of the point of the triangle (a, b, c) closest to `query`.
/// Triangles without area are segments or points. Coordinates are exactly 0 on the edges and corners hit.
Vec3 closest_barycentric(const Vec3& query, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace partwise
