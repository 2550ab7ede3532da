#include "geometry/surface_index.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "builders.h"
#include "error.h"
#include "geometry/triangle_queries.h"

namespace partwise {
namespace {

/// Random points in [-scale, scale]^3, the same on each run.
Points scattered(int count, double scale) {
  std::mt19937 random(42);
  std::uniform_real_distribution<double> coordinate(-scale, scale);
  Points points;
  for (int i = 0; i < count; ++i)
    points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
  return points;
}

TEST(SurfaceIndex, ClosestAgreesWithTryingEveryFacet) {
  for (const TriMesh& mesh :
       {tests::bumpy_sphere(6, 0.4), tests::torus(1, 0.3, 20, 10), tests::tetrahedron()}) {
    const SurfaceIndex index(mesh);
    for (const Vec3& query : scattered(200, 2)) {
      double smallest = 1e300;
      for (const auto& [a, b, c] : mesh.facets()) {
        smallest = std::min(
            smallest,
            closest_on_triangle(query, mesh.point(a), mesh.point(b), mesh.point(c)).squared_distance);
      }
      const SurfaceHit hit = index.closest(query);
      EXPECT_NEAR(hit.distance, std::sqrt(smallest), 1e-14);
      EXPECT_NEAR((hit.position - query).norm(), hit.distance, 1e-15);
      EXPECT_EQ(hit.position, position(mesh, hit.point));
      EXPECT_NEAR(hit.point.barycentric.sum(), 1, 1e-15);
      EXPECT_GE(hit.point.barycentric.minCoeff(), 0);
      EXPECT_TRUE(index.has_within(hit.distance * (1 + 1e-12), query));
      EXPECT_FALSE(index.has_within(hit.distance * (1 - 1e-12), query));
    }
  }
}

TEST(SurfaceIndex, ClosestOnACubeIsKnown) {
  const SurfaceIndex index(tests::cube(3));
  EXPECT_LT((index.closest({5, 0.1, 0.2}).position - Vec3(1, 0.1, 0.2)).norm(), 1e-15);
  EXPECT_LT((index.closest({5, 5, 0.2}).position - Vec3(1, 1, 0.2)).norm(), 1e-15);
  EXPECT_LT((index.closest({2, 2, 2}).position - Vec3(1, 1, 1)).norm(), 1e-15);
  EXPECT_DOUBLE_EQ(index.closest({2, 2, 2}).distance, std::sqrt(3.0));
}

TEST(SurfaceIndex, RaysFromInsideNeverSlipThrough) {
  const TriMesh mesh = tests::sphere(8);
  const SurfaceIndex index(mesh);
  Points directions = scattered(500, 1);
  directions.insert(directions.end(), mesh.points().begin(), mesh.points().end());
  for (const auto& [a, b, c] : mesh.facets()) {  // through edges
    directions.push_back(0.3 * mesh.point(a) + 0.7 * mesh.point(b));
  }
  const Vec3 origin(0.01, -0.02, 0.03);
  for (const Vec3& through : directions) {
    const Vec3 direction = through - origin;
    const auto hit = index.first_hit(origin, direction);
    ASSERT_TRUE(hit) << direction.transpose();
    EXPECT_LT((hit->position - origin).normalized().cross(direction.normalized()).norm(), 1e-13);
    EXPECT_GT((hit->position - origin).dot(direction), 0);
    EXPECT_EQ(hit->position, position(mesh, hit->point));
  }
}

TEST(SurfaceIndex, HitsComeByDistanceAndStartAtTheOrigin) {
  const TriMesh mesh = tests::cube(3);
  const SurfaceIndex index(mesh);
  const auto through = index.all_hits({-3, 0.11, 0.23}, {2, 0, 0});
  ASSERT_EQ(through.size(), 2U);
  EXPECT_DOUBLE_EQ(through[0].distance, 2);
  EXPECT_DOUBLE_EQ(through[1].distance, 4);
  EXPECT_DOUBLE_EQ(index.first_hit({-3, 0.11, 0.23}, {2, 0, 0})->distance, 2);
  EXPECT_TRUE(index.all_hits({-3, 0.11, 0.23}, {-1, 0, 0}).empty());
  EXPECT_FALSE(index.first_hit({-3, 2, 0}, {1, 0, 0}));
  EXPECT_NEAR(index.first_hit({1, 0.11, 0.23}, {1, 0, 0})->distance, 0, 1e-15);
}

TEST(SurfaceIndex, FacetsWithoutAreaDoNotDisturb) {
  // A square whose diagonal carries a facet folded to a segment, and one shrunk to a point.
  const Points points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}};
  const SurfaceIndex index(points, {{0, 1, 2}, {0, 2, 4}, {4, 4, 4}, {0, 2, 3}});
  const SurfaceHit hit = index.closest({0.5, 0.5, 1});
  EXPECT_DOUBLE_EQ(hit.distance, 1);
  EXPECT_TRUE(hit.position.allFinite());
  const auto ray = index.first_hit({0.5, 0.5, 1}, {0, 0, -1});
  ASSERT_TRUE(ray);
  EXPECT_DOUBLE_EQ(ray->distance, 1);
  const SurfaceIndex only_segment(points, {{0, 2, 4}});
  EXPECT_NEAR(only_segment.closest({1, 0, 0}).distance, std::sqrt(0.5), 1e-15);
  EXPECT_FALSE(only_segment.first_hit({0.5, 0.5, 1}, {0, 0, -1}));
}

TEST(SurfaceIndex, ScalesWithTheModel) {
  const TriMesh mesh = tests::torus(1, 0.3, 20, 10);
  for (const double scale : {1e-8, 1e8}) {
    Points scaled = mesh.points();
    for (Vec3& p : scaled) p *= scale;
    const SurfaceIndex index(mesh), scaled_index(scaled, mesh.facets());
    for (const Vec3& query : scattered(100, 2)) {
      EXPECT_NEAR(scaled_index.closest(scale * query).distance / scale, index.closest(query).distance, 1e-13);
      EXPECT_EQ(scaled_index.all_hits(scale * query, Vec3(-query)).size(),
                index.all_hits(query, Vec3(-query)).size());
    }
  }
}

TEST(SurfaceIndex, ClosestPointOfASliverIsRight) {
  // A needle of height 1e-9: its normal is mostly rounding when it lies askew.
  const Vec3 along = Vec3(1, 2, 3).normalized(), across = along.unitOrthogonal();
  const Points points{Vec3::Zero(), along, 0.4 * along + 1e-9 * across};
  const SurfaceIndex index(points, {{0, 1, 2}});
  for (const double at : {0.1, 0.5, 0.9}) {
    const SurfaceHit hit = index.closest(at * along + 0.2 * along.cross(across));
    EXPECT_NEAR(hit.distance, 0.2, 1e-9);
    EXPECT_LT((hit.position - at * along).norm(), 2e-9);
  }
}

TEST(SurfaceIndex, NeedsAFacet) {
  EXPECT_THROW(SurfaceIndex({{0, 0, 0}}, {}), InputError);
}

}  // namespace
}  // namespace partwise
