#include "mesh/curve_roughness.h"

#include <gtest/gtest.h>

#include <cmath>

#include "builders.h"
#include "mesh/segmentation.h"

namespace partwise {
namespace {

Points zigzag(int n, double height) {
  Points points;
  for (int i = 0; i < n; ++i) points.emplace_back(i, i % 2 == 0 ? 0 : height, 0);
  return points;
}

TEST(CurveRoughness, StraightLineHasNone) {
  EXPECT_NEAR(curve_roughness(zigzag(20, 0), false), 1, 1e-14);
}

TEST(CurveRoughness, ZigzagIsLongerThanItsMiddle) {
  // One round takes the zigzag's teeth off entirely; only the fixed ends keep a little slope.
  EXPECT_NEAR(curve_roughness(zigzag(201, 1), false), std::sqrt(2.0), 0.01);
  EXPECT_LT(curve_roughness(zigzag(201, 0.2), false), 1.03);
}

TEST(CurveRoughness, ClosedCurveShrinksAsSaid) {
  Points circle;
  constexpr int n = 48;
  for (int i = 0; i < n; ++i) circle.emplace_back(std::cos(2 * M_PI * i / n), std::sin(2 * M_PI * i / n), 3);
  // Each round multiplies the radius by (1 + cos(2 pi / n)) / 2.
  const double shrinking = std::pow((1 + std::cos(2 * M_PI / n)) / 2, kRoughnessRounds);
  EXPECT_NEAR(curve_roughness(circle, true), 1 / shrinking, 1e-12);
}

TEST(CurveRoughness, ScaleMeansNothing) {
  Points points = zigzag(30, 0.7);
  const double rough = curve_roughness(points, true);
  for (Vec3& p : points) p = 1000 * p + Vec3(5, 6, 7);
  EXPECT_NEAR(curve_roughness(points, true), rough, 1e-12);
}

TEST(CurveRoughness, PointIsNotRough) {
  EXPECT_EQ(curve_roughness({}, false), 1);
  EXPECT_EQ(curve_roughness({Vec3::Zero()}, true), 1);
  EXPECT_EQ(curve_roughness({Vec3::Zero(), Vec3::Zero()}, false), 1);
}

TEST(CurveRoughness, MeanWeighsByLength) {
  const TriMesh mesh = tests::cube(6);
  std::vector<int> labels(mesh.facet_count());
  for (int f = 0; f < mesh.facet_count(); ++f) labels[f] = mesh.point(mesh.facet(f)[0]).z() > 0.1;
  const Segmentation halves = trace_boundaries(mesh, {"a", "b"}, labels);
  ASSERT_EQ(halves.curves.size(), 1U);
  EXPECT_GT(curve_roughness(mesh, halves.curves[0]), 1);
  EXPECT_NEAR(mean_roughness(mesh, halves), curve_roughness(mesh, halves.curves[0]), 1e-12);
}

}  // namespace
}  // namespace partwise
