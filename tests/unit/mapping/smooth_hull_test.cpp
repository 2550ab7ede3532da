#include "mapping/smooth_hull.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

#include "builders.h"
#include "geometry/convex_hull.h"

namespace partwise {
namespace {

constexpr double kSpacing = 0.05;

/// The hull of a box about the origin.
ConvexHull box(const Vec3& half, const Eigen::Matrix3d& turn) {
  Points corners;
  for (int i = 0; i < 8; ++i) {
    corners.push_back(turn * Vec3(i & 1 ? half.x() : -half.x(), i & 2 ? half.y() : -half.y(),
                                  i & 4 ? half.z() : -half.z()));
  }
  return convex_hull(corners);
}

Points directions() {
  return tests::sphere(6).points();
}

class OfALongBox : public testing::Test {
 protected:
  Eigen::Matrix3d turn = Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  StarHull hull{box({3, 1, 0.5}, turn), Vec3::Zero()};
  SmoothHull smooth{hull, kSpacing};
};

TEST_F(OfALongBox, LiesInsideAndOnTheHullAwayFromItsEdges) {
  int on = 0;
  for (const Vec3& direction : directions()) {
    const double outer = hull.project(direction, 0).position.norm(),
                 inner = smooth.project(direction).position.norm();
    EXPECT_LE(inner, outer * (1 + 1e-12));
    EXPECT_GT(inner, outer * 0.85);
    if (inner > outer * (1 - 1e-12)) ++on;
  }
  EXPECT_GT(on, static_cast<int>(directions().size()) / 2);
}

TEST_F(OfALongBox, DerivativesAgreeWithDifferences) {
  constexpr double h = 1e-6;
  for (const Vec3& direction : directions()) {
    const Vec3 p = 0.7 * direction;
    const SmoothHull::Gauge gauge = smooth.gauge(p);
    EXPECT_NEAR(gauge.gradient.dot(p), gauge.value, 1e-12);  // linear along rays
    EXPECT_NEAR((smooth.project(p).position * gauge.value - p).norm(), 0, 1e-12);
    for (int i = 0; i < 3; ++i) {
      const SmoothHull::Gauge above = smooth.gauge(p + h * Vec3::Unit(i));
      const SmoothHull::Gauge below = smooth.gauge(p - h * Vec3::Unit(i));
      EXPECT_NEAR(gauge.gradient[i], (above.value - below.value) / (2 * h), 1e-7);
      EXPECT_LT((gauge.hessian.col(i) - (above.gradient - below.gradient) / (2 * h)).norm(), 1e-4);
    }
    EXPECT_LT((gauge.hessian - gauge.hessian.transpose()).norm(), 1e-9 * (1 + gauge.hessian.norm()));
  }
}

TEST_F(OfALongBox, TurnsAndScalesWithTheHull) {
  const Eigen::Matrix3d motion =
      1000 * Eigen::AngleAxisd(2.1, Vec3(-1, 1, 0.3).normalized()).toRotationMatrix();
  const SmoothHull moved(StarHull(box({3, 1, 0.5}, motion * turn), Vec3::Zero()), kSpacing);
  for (const Vec3& direction : directions()) {
    const Vec3 expected = motion * smooth.project(direction).position;
    EXPECT_LT((moved.project(motion * direction).position - expected).norm(), 1e-9 * expected.norm());
  }
}

}  // namespace
}  // namespace partwise
