#include "measure/surface_distance.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <numbers>

#include "builders.h"
#include "error.h"
#include "measure/surface_samples.h"

namespace partwise {
namespace {

Points transformed(const Points& points, auto&& function) {
  Points result;
  for (const Vec3& p : points) result.push_back(function(p));
  return result;
}

TEST(SurfaceSamples, LieOnTheSurfaceAndAreCounted) {
  const TriMesh grid = tests::grid(3);
  const Points samples = sample_surface(grid.points(), grid.facets(), 1000, 1);
  ASSERT_EQ(samples.size(), 1000U);
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : samples) {
    EXPECT_EQ(p.z(), 0);
    EXPECT_LE(std::max(std::abs(p.x()), std::abs(p.y())), 1);
    mean += p / 1000;
  }
  EXPECT_LT(mean.norm(), 0.05);
}

TEST(SurfaceSamples, FollowAreaNotFacets) {
  // One facet with 3/4 of the area, one with 1/4, one without any.
  const Points points{{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {4, 0, 0}, {5, 0, 0}};
  const Points samples = sample_surface(points, {{0, 1, 2}, {1, 3, 2}, {3, 4, 3}}, 400, 7);
  int in_first = 0;
  for (const Vec3& p : samples) in_first += p.x() < 3;
  EXPECT_EQ(in_first, 300);
}

TEST(SurfaceSamples, ASurfaceWithoutAreaHasNone) {
  EXPECT_TRUE(sample_surface({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}, 10, 1).empty());
}

TEST(SurfaceDistance, OfEqualMeshesIsZero) {
  const TriMesh cube = tests::cube(4);
  const SurfaceDistance distance = surface_distance(cube, cube, {.samples = 500});
  EXPECT_LT(distance.rms, 1e-15);
  EXPECT_LT(distance.max, 1e-15);
  EXPECT_LT(distance.forward.max_at_vertices, 1e-15);
}

TEST(SurfaceDistance, OfParallelPlanesIsTheirOffset) {
  const TriMesh grid = tests::grid(5);
  const TriMesh lifted = grid.with_points(
      transformed(grid.points(), [](const Vec3& p) -> Vec3 { return p + Vec3(0, 0, 0.25); }));
  const SurfaceDistance distance = surface_distance(grid, lifted, {.samples = 500});
  EXPECT_NEAR(distance.rms, 0.25, 1e-14);
  EXPECT_NEAR(distance.max, 0.25, 1e-14);
  EXPECT_NEAR(distance.backward.rms, 0.25, 1e-14);
}

TEST(SurfaceDistance, OfConcentricSpheresIsTheDifferenceOfRadii) {
  const TriMesh sphere = tests::sphere(24);
  const TriMesh larger =
      sphere.with_points(transformed(sphere.points(), [](const Vec3& p) -> Vec3 { return 1.5 * p; }));
  const SurfaceDistance distance = surface_distance(sphere, larger, {.samples = 5000});
  EXPECT_NEAR(distance.max, 0.5, 2e-3);
  EXPECT_NEAR(distance.rms, 0.5, 2e-3);
}

TEST(SurfaceDistance, SeesWhatOnlyOneSideHas) {
  // A tent of height 1 over the middle of a plane: the plane is everywhere near the tent's foot or below it.
  const TriMesh grid = tests::grid(4);
  Points points = grid.points();
  points[12].z() = 1;
  const SurfaceDistance distance = surface_distance(grid, grid.with_points(points), {.samples = 2000});
  EXPECT_NEAR(distance.backward.max, 1, 1e-14);
  EXPECT_LT(distance.forward.max, 0.5);
  EXPECT_EQ(distance.max, distance.backward.max);
}

TEST(SurfaceDistance, RmsOfATiltedPlaneIsTheIntegral) {
  // Two squares hinged at x = -1, at the angle a: distances run from 0 to about 2 sin(a); one way they are
  // exactly the offset over a wide enough plane.
  const TriMesh wide = tests::grid(2).with_points(
      transformed(tests::grid(2).points(), [](const Vec3& p) -> Vec3 { return 10 * p; }));
  const double angle = 0.3;
  const TriMesh tilted = tests::grid(6).with_points(transformed(tests::grid(6).points(), [&](const Vec3& p) {
    return Vec3((p.x() + 1) * std::cos(angle), p.y(), (p.x() + 1) * std::sin(angle));
  }));
  const SurfaceDistance distance = surface_distance(tilted, wide, {.samples = 20000});
  const double analytic = 2 * std::sin(angle) / std::sqrt(3.0);
  EXPECT_NEAR(distance.forward.rms, analytic, 1e-3 * analytic);
  EXPECT_NEAR(distance.forward.max, 2 * std::sin(angle), 1e-12);
}

TEST(SurfaceDistance, GrowsWithTheModelsAndNothingElse) {
  const TriMesh first = tests::sphere(8), second = tests::bumpy_sphere(12, 0.2);
  const SurfaceDistance here = surface_distance(first, second, {.samples = 3000});
  const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, 3).normalized());
  auto moved = [&](const Vec3& p) -> Vec3 { return 1000 * (turn * p) + Vec3(5e3, -2e3, 1e3); };
  const SurfaceDistance there =
      surface_distance(first.with_points(transformed(first.points(), moved)),
                       second.with_points(transformed(second.points(), moved)), {.samples = 3000});
  EXPECT_NEAR(there.rms / 1000, here.rms, 1e-9);
  EXPECT_NEAR(there.max / 1000, here.max, 1e-9);
}

TEST(SurfaceDistance, IsTheSameOnAnyNumberOfThreads) {
  const TriMesh first = tests::sphere(8), second = tests::bumpy_sphere(12, 0.2);
  auto with_threads = [&](std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return surface_distance(first, second, {.samples = 4000});
  };
  const SurfaceDistance one = with_threads(1), four = with_threads(4);
  EXPECT_EQ(one.rms, four.rms);
  EXPECT_EQ(one.max, four.max);
  EXPECT_EQ(one.backward.rms, four.backward.rms);
}

TEST(SurfaceDistance, NeedsSamples) {
  EXPECT_THROW(surface_distance(tests::cube(1), tests::cube(1), {.samples = 0}), InputError);
}

}  // namespace
}  // namespace partwise
