#include "measure/distortion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "builders.h"
#include "error.h"
#include "measure/degenerate_facets.h"

namespace partwise {
namespace {

Points scaled(const Points& points, const Vec3& factors) {
  Points result;
  for (const Vec3& p : points) result.push_back(p.cwiseProduct(factors));
  return result;
}

TEST(SingularValues, OfAStretchAreItsFactors) {
  const std::array<Vec3, 3> original{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.3, 1, 0)};
  const Eigen::AngleAxisd turn(1.1, Vec3(1, -2, 0.5).normalized());
  std::array<Vec3, 3> image;
  for (int i = 0; i < 3; ++i) image[i] = turn * original[i].cwiseProduct(Vec3(3, 0.5, 1)) + Vec3(7, 8, 9);
  const auto [s1, s2] = singular_values(original, image);
  EXPECT_NEAR(s1, 3, 1e-12);
  EXPECT_NEAR(s2, 0.5, 1e-12);
}

TEST(SingularValues, OfACollapseHaveAZero) {
  const auto [s1, s2] = singular_values({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                                        {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 0, 0)});
  EXPECT_NEAR(s1, 2, 1e-12);
  EXPECT_NEAR(s2, 0, 1e-12);
}

TEST(Distortion, OfASimilarityIsNone) {
  const TriMesh sphere = tests::sphere(6);
  const Distortion result =
      distortion(sphere.points(), scaled(sphere.points(), Vec3(-5, -5, 5)), sphere.facets());
  EXPECT_NEAR(result.l2_stretch_efficiency, 1, 1e-12);
  EXPECT_NEAR(result.symmetric_dirichlet, 4, 1e-12);
  EXPECT_NEAR(result.symmetric_dirichlet_median, 4, 1e-12);
  EXPECT_NEAR(result.angle_error_degrees, 0, 1e-10);
  EXPECT_EQ(result.clamped_facets, 0);
}

TEST(Distortion, OfAGridStretchedTwiceAlongXIsKnown) {
  // Scaled to equal area the singular values are sqrt(2) and 1/sqrt(2) everywhere.
  const TriMesh grid = tests::grid(3);
  const Distortion result = distortion(grid.points(), scaled(grid.points(), Vec3(2, 1, 1)), grid.facets());
  EXPECT_NEAR(result.l2_stretch_efficiency, 1 / ((2 + 0.5) / 2), 1e-12);
  EXPECT_NEAR(result.symmetric_dirichlet, 2 * (2 + 0.5), 1e-12);
  EXPECT_NEAR(result.symmetric_dirichlet_median, 2 * (2 + 0.5), 1e-12);
  // Every facet is half a square: angles 45, 90, 45 become 26.565, 90, 63.435.
  EXPECT_NEAR(result.angle_error_degrees, 2 * (45 - std::atan(0.5) * 180 / M_PI) / 3, 1e-9);
}

TEST(Distortion, UnequalScalesCostThoughAnglesAreKept) {
  // Two squares apart, one doubled: s = 1 and 2 times a common factor, areas 1 + 1 -> 1 + 4.
  const Points original{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}};
  const Points image{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {7, 0, 0}, {5, 2, 0}};
  const Distortion result = distortion(original, image, {{0, 1, 2}, {3, 4, 5}});
  const double a = 1 / 2.5, b = 4 / 2.5;  // squared singular values after scaling to area 2.5
  EXPECT_NEAR(result.symmetric_dirichlet, ((2 * a + 2 / a) + (2 * b + 2 / b)) / 2, 1e-12);
  EXPECT_NEAR(result.l2_stretch_efficiency, 2.5 / (0.5 * a + 2 * b), 1e-12);
  EXPECT_NEAR(result.angle_error_degrees, 0, 1e-12);
}

TEST(Distortion, CollapsedFacetsAreClampedAndCounted) {
  const TriMesh grid = tests::grid(2);
  Points image = grid.points();
  image[4] = image[3];  // the middle vertex onto a neighbour
  const Distortion result = distortion(grid.points(), image, grid.facets());
  EXPECT_EQ(result.clamped_facets, 2);
  EXPECT_TRUE(std::isfinite(result.symmetric_dirichlet));
  EXPECT_GT(result.symmetric_dirichlet, 1e4);
  EXPECT_LT(result.symmetric_dirichlet_median, 100);
}

TEST(Distortion, OfNothingIsAnError) {
  EXPECT_THROW(distortion({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}),
               InputError);
}

TEST(DegenerateFacets, AreCollapsedFacetsAndSlivers) {
  const Points points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 1e-9, 0}, {0, 0, 1e-6}, {1e-6, 0, 0}};
  const Facets facets{{0, 1, 2}, {0, 3, 1}, {0, 5, 4}, {1, 1, 2}};
  EXPECT_EQ(degenerate_facets(points, facets), (std::vector<int>{1, 2, 3}));
  Points large;
  for (const Vec3& p : points) large.push_back(1e8 * p);
  EXPECT_EQ(degenerate_facets(large, facets), (std::vector<int>{1, 2, 3}));
  EXPECT_TRUE(degenerate_facets(tests::sphere(5).points(), tests::sphere(5).facets()).empty());
}

}  // namespace
}  // namespace partwise
