#include "mesh/surface_walk.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "builders.h"

namespace partwise {
namespace {

/// The point of the flat grid above (x, y).
SurfacePoint at(const SurfaceWalker& walker, double x, double y) {
  for (int f = 0; f < walker.mesh().facet_count(); ++f) {
    const SurfacePoint corner{f, Vec3(1, 0, 0)};
    const SurfacePoint point = walker.towards(corner, {x, y, 0});
    if ((position(walker.mesh(), point) - Vec3(x, y, 0)).norm() < 1e-12) return point;
  }
  return {};
}

TEST(SurfaceWalk, OnAPlaneIsTheStraightLine) {
  const SurfaceWalker walker(tests::grid(7));
  const SurfacePoint start = at(walker, -0.83, -0.71);
  ASSERT_GE(start.facet, 0);
  for (const Vec3& step : {Vec3(1.3, 0.2, 0), Vec3(0.1, 1.5, 0), Vec3(1.1, 1.1, 0.7), Vec3(0.01, 0.0, 0)}) {
    const SurfaceWalk walk = walker.straight(start, step);
    const Vec3 expected(-0.83 + step.x(), -0.71 + step.y(), 0);
    EXPECT_NEAR((position(walker.mesh(), walk.end) - expected).norm(), 0, 1e-12);
    EXPECT_NEAR(walk.length, step.head<2>().norm(), 1e-12);
    EXPECT_FALSE(walk.at_boundary);
    EXPECT_GE(walk.end.barycentric.minCoeff(), 0);
    EXPECT_NEAR(walk.end.barycentric.sum(), 1, 1e-12);
  }
}

TEST(SurfaceWalk, CrossesVerticesAndFollowsEdges) {
  const SurfaceWalker walker(tests::grid(4));
  const SurfacePoint start = at(walker, -1, -1);
  const SurfaceWalk diagonal = walker.straight(start, {1.25, 1.25, 0});
  EXPECT_NEAR((position(walker.mesh(), diagonal.end) - Vec3(0.25, 0.25, 0)).norm(), 0, 1e-12);
}

TEST(SurfaceWalk, EndsAtTheBoundary) {
  const SurfaceWalker walker(tests::grid(5));
  const SurfaceWalk walk = walker.straight(at(walker, 0.1, 0.1), {3, 0, 0});
  EXPECT_TRUE(walk.at_boundary);
  EXPECT_NEAR((position(walker.mesh(), walk.end) - Vec3(1, 0.1, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR(walk.length, 0.9, 1e-12);
}

/// A straight line around a cube, across four edges, comes back to where it started.
TEST(SurfaceWalk, ReturnsOnAClosedGeodesic) {
  const SurfaceWalker walker(tests::cube(3));
  int front = 0;
  while (position(walker.mesh(), {front, Vec3::Constant(1.0 / 3)}).x() < 0.99) ++front;
  const SurfacePoint start = walker.towards({front, Vec3(1, 0, 0)}, {1, 0.137, 0.21});
  ASSERT_NEAR((position(walker.mesh(), start) - Vec3(1, 0.137, 0.21)).norm(), 0, 1e-12);
  const SurfaceWalk straight_round = walker.straight(start, {0, 8, 0});
  EXPECT_NEAR((position(walker.mesh(), straight_round.end) - Vec3(1, 0.137, 0.21)).norm(), 0, 1e-10);
  EXPECT_NEAR((straight_round.direction - Vec3(0, 1, 0)).norm(), 0, 1e-10);
  EXPECT_NEAR(straight_round.length, 8, 1e-10);
}

TEST(SurfaceWalk, RunsAlongAGreatCircleOfASphere) {
  const SurfaceWalker walker(tests::sphere(40));
  const SurfacePoint start = walker.towards({0, Vec3(1, 0, 0)}, Vec3(1, 0.3, 0.2));
  const Vec3 from = position(walker.mesh(), start).normalized();
  const Vec3 direction = from.cross(Vec3(0.2, -0.5, 1)).normalized();
  const SurfaceWalk quarter = walker.straight(start, std::numbers::pi / 2 * direction);
  EXPECT_NEAR((position(walker.mesh(), quarter.end) - direction).norm(), 0, 0.02);
}

TEST(SurfaceWalk, TowardsAPointFindsItOnAConvexSurface) {
  const SurfaceWalker walker(tests::sphere(15));
  const SurfacePoint goal{walker.mesh().facet_count() - 7, Vec3(0.2, 0.3, 0.5)};
  const Vec3 there = position(walker.mesh(), goal);
  for (int f = 0; f < walker.mesh().facet_count(); f += 97) {
    const SurfacePoint found = walker.towards({f, Vec3(0.6, 0.2, 0.2)}, there);
    EXPECT_EQ(found.facet, goal.facet);
    EXPECT_NEAR((position(walker.mesh(), found) - there).norm(), 0, 1e-12);
  }
}

/// A sheet folded onto itself: below each point of the upper half lies the lower half, at distance 0.1.
TEST(SurfaceWalk, TowardsStaysOnItsSheet) {
  const TriMesh flat = tests::grid(20);
  Points folded;
  for (const Vec3& p : flat.points()) folded.emplace_back(-std::abs(p.x()), p.y(), p.x() > 0 ? 0 : 0.1);
  const SurfaceWalker walker(flat.with_points(folded));
  int upper = 0;
  for (int f = 0; f < flat.facet_count(); ++f) {
    const Vec3 centre = position(walker.mesh(), {f, Vec3::Constant(1.0 / 3)});
    if (centre.z() < 0.1) continue;
    ++upper;
    const SurfacePoint end = walker.towards({f, Vec3(1, 0, 0)}, centre - Vec3(0, 0, 0.09));
    EXPECT_NEAR((position(walker.mesh(), end) - centre).norm(), 0, 1e-12);
  }
  EXPECT_EQ(upper, 400);
}

TEST(SurfaceWalk, SeenFromTheOtherSideOfAnEdgeIsTheSamePoint) {
  const TriMesh flat = tests::grid(2);
  const SurfaceWalker walker(flat);
  const SurfacePoint on_edge{0, Vec3(0.25, 0, 0.75)};
  const SurfacePoint other = seen_from(flat, on_edge, walker.neighbour(0, 2));
  EXPECT_EQ(other.facet, 1);
  EXPECT_EQ(position(flat, other), position(flat, on_edge));
  EXPECT_EQ(seen_from(flat, {0, Vec3(0.5, 0.25, 0.25)}, 1).facet, -1);
}

}  // namespace
}  // namespace partwise
