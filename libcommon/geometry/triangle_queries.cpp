#include "geometry/triangle_queries.h"

#include <algorithm>
#include <limits>

namespace partwise {
namespace {

/// Closest point on the segment (a, b) as the weight of b.
double weight_on_segment(const Vec3& query, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double squared_length = along.squaredNorm();
  return squared_length > 0 ? std::clamp((query - a).dot(along) / squared_length, 0.0, 1.0) : 0;
}

}  // namespace

TriangleProximity closest_on_triangle(const Vec3& query, const Vec3& a, const Vec3& b, const Vec3& c) {
  const std::array<Vec3, 3> corners{a, b, c};
  TriangleProximity best{Vec3::Zero(), std::numeric_limits<double>::infinity()};
  const auto offer = [&](const Vec3& barycentric) {
    const Vec3 at = barycentric[0] * a + barycentric[1] * b + barycentric[2] * c;
    const double squared = (query - at).squaredNorm();
    if (squared < best.squared_distance) best = {barycentric, squared};
  };
  const Vec3 normal = (b - a).cross(c - a);
  const double squared_normal = normal.squaredNorm();
  if (squared_normal > 0) {
    const Vec3 inside((c - b).cross(query - b).dot(normal) / squared_normal,
                      (a - c).cross(query - c).dot(normal) / squared_normal,
                      (b - a).cross(query - a).dot(normal) / squared_normal);
    if (inside.minCoeff() >= 0) {
      offer(inside / inside.sum());
      // In a sliver the normal is mostly rounding; there the edges may know better.
      const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
      if (squared_normal > 1e-16 * longest * longest) return best;
    }
  }
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const double weight = weight_on_segment(query, corners[i], corners[j]);
    Vec3 barycentric = Vec3::Zero();
    barycentric[i] = 1 - weight;
    barycentric[j] = weight;
    offer(barycentric);
  }
  return best;
}

TriangleRay::TriangleRay(const Vec3& origin, const Vec3& direction) : origin_(origin), direction_(direction) {
  direction_.cwiseAbs().maxCoeff(&z_);
  x_ = (z_ + 1) % 3;
  y_ = (z_ + 2) % 3;
  shear_x_ = direction_[x_] / direction_[z_];
  shear_y_ = direction_[y_] / direction_[z_];
}

std::optional<TriangleCrossing> TriangleRay::crossing(const Vec3& a, const Vec3& b, const Vec3& c) const {
  std::array<Eigen::Vector2d, 3> flat;
  Vec3 heights;
  for (int i = 0; const Vec3* corner : {&a, &b, &c}) {
    const Vec3 at = *corner - origin_;
    flat[i] = {at[x_] - shear_x_ * at[z_], at[y_] - shear_y_ * at[z_]};
    heights[i++] = at[z_] / direction_[z_];
  }
  const auto edge = [](const Eigen::Vector2d& p, const Eigen::Vector2d& q) {
    return p.x() * q.y() - p.y() * q.x();
  };
  const Vec3 weights(edge(flat[1], flat[2]), edge(flat[2], flat[0]), edge(flat[0], flat[1]));
  if (weights.minCoeff() < 0 && weights.maxCoeff() > 0) return std::nullopt;
  const double sum = weights.sum();
  if (sum == 0) return std::nullopt;
  const Vec3 barycentric = weights / sum;
  const double parameter = barycentric.dot(heights);
  if (!(parameter >= 0)) return std::nullopt;
  return TriangleCrossing{parameter, barycentric};
}

}  // namespace partwise
