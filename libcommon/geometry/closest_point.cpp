#include "geometry/closest_point.h"

#include <algorithm>
#include <array>
#include <limits>

namespace partwise {
namespace {

/// Share of `b` in the point of the segment (a, b) closest to `query`.
double closest_share(const Vec3& query, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double length_squared = along.squaredNorm();
  return length_squared > 0 ? std::clamp((query - a).dot(along) / length_squared, 0.0, 1.0) : 0.0;
}

}  // namespace

Vec3 closest_barycentric(const Vec3& query, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a);
  const double area = normal.squaredNorm();
  if (area > 0) {
    const Vec3 inside((c - b).cross(query - b).dot(normal), (a - c).cross(query - c).dot(normal),
                      (b - a).cross(query - a).dot(normal));
    if (inside.minCoeff() >= 0) return inside / inside.sum();
  }
  const std::array<const Vec3*, 3> corners{&a, &b, &c};
  double nearest = std::numeric_limits<double>::infinity();
  Vec3 result = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const double share = closest_share(query, *corners[i], *corners[j]);
    const double distance = (query - (1 - share) * *corners[i] - share * *corners[j]).squaredNorm();
    if (distance >= nearest) continue;
    nearest = distance;
    result = Vec3::Zero();
    result[i] = 1 - share;
    result[j] = share;
  }
  return result;
}

}  // namespace partwise
