#pragma once

#include <optional>

#include "mesh/types.h"

namespace partwise {

/// The point of a triangle closest to another point.
struct TriangleProximity {
  Vec3 barycentric = Vec3::Zero();  ///< non-negative, sum 1
  double squared_distance = 0;
};

/// Closest point on the triangle (a, b, c), which may be degenerate (a segment or a point).
TriangleProximity closest_on_triangle(const Vec3& query, const Vec3& a, const Vec3& b, const Vec3& c);

/// Where a ray crosses a triangle: origin + parameter * direction.
struct TriangleCrossing {
  double parameter = 0;             ///< >= 0
  Vec3 barycentric = Vec3::Zero();  ///< non-negative, sum 1
};

/// A ray for tests against many triangles that lets nothing slip between two of them.
///
/// Watertight (Woop, Benthin and Wald 2013): a ray through a common edge of two triangles hits at least one,
/// because the edge's test gives opposite signs for them exactly, and edges belong to both.
class TriangleRay {
 public:
  /// \pre direction is not zero
  TriangleRay(const Vec3& origin, const Vec3& direction);

  const Vec3& origin() const { return origin_; }
  const Vec3& direction() const { return direction_; }

  /// None also for a triangle that the ray lies in, and for one without area.
  std::optional<TriangleCrossing> crossing(const Vec3& a, const Vec3& b, const Vec3& c) const;

 private:
  Vec3 origin_, direction_;
  int x_, y_, z_;             // axes, z_ the one along which the ray is steepest
  double shear_x_, shear_y_;  // bring the ray onto the z axis
};

}  // namespace partwise
