#include "remeshing/critical_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "builders.h"
#include "error.h"

namespace partwise {
namespace {

/// A bumpy sphere without symmetry, so that no two vertices are equally curved.
TriMesh uneven_bumpy_sphere(int n) {
  const TriMesh bumpy = tests::bumpy_sphere(n, 0.4);
  Points points = bumpy.points();
  for (Vec3& p : points) p *= 1 + 0.03 * std::sin(3 * p.x() + 1) * std::cos(2 * p.y() + p.z() + 0.5);
  return bumpy.with_points(points);
}

std::vector<int> vertices_of(const CriticalPoints& critical) {
  std::vector<int> vertices;
  for (const CriticalPoint& c : critical.points) vertices.push_back(c.vertex);
  return vertices;
}

TEST(CriticalPoints, SixOfABumpySphereAreItsBumps) {
  const TriMesh bumpy = tests::bumpy_sphere(20, 0.4);
  const CriticalPoints critical = find_critical_points(bumpy, {.fraction = 1, .count = 6});
  ASSERT_EQ(critical.points.size(), 6U);
  EXPECT_GT(critical.radius_scale, 1);
  for (const CriticalPoint& c : critical.points) {
    EXPECT_NEAR(bumpy.point(c.vertex).norm(), 1.4, 1e-9) << "vertex " << c.vertex;
  }
}

TEST(CriticalPoints, AreMostCurvedFirstAndOutsideOfEarlierRegions) {
  const TriMesh mesh = uneven_bumpy_sphere(16);
  const CriticalPoints critical = find_critical_points(mesh, {.fraction = 1});
  EXPECT_EQ(critical.radius_scale, 1);
  for (std::size_t i = 0; i < critical.points.size(); ++i) {
    const CriticalPoint& c = critical.points[i];
    EXPECT_NEAR(c.radius, std::min(mesh.diagonal(), 1 / (mesh.diagonal() * std::abs(c.curvature))), 1e-12);
    if (i > 0) {
      EXPECT_LE(std::abs(c.curvature), std::abs(critical.points[i - 1].curvature) * (1 + 1e-8));
    }
  }
}

TEST(CriticalPoints, LeaveNoVertexFarFromOne) {
  const TriMesh mesh = uneven_bumpy_sphere(16);
  const CriticalPoints critical = find_critical_points(mesh, {.fraction = 0.05});
  EXPECT_LE(critical.points.size(), mesh.vertex_count() * 0.05);
  EXPECT_GT(critical.points.size(), mesh.vertex_count() * 0.03);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const bool covered = std::any_of(critical.points.begin(), critical.points.end(), [&](const auto& c) {
      return (mesh.point(v) - mesh.point(c.vertex)).norm() <= c.radius;
    });
    EXPECT_TRUE(covered) << "vertex " << v;
  }
}

TEST(CriticalPoints, RegionsShareOutTheVerticesAndStayWithinTheirRadius) {
  const TriMesh mesh = uneven_bumpy_sphere(16);
  std::vector<int> owners(mesh.vertex_count(), 0);
  for (const CriticalPoint& c : find_critical_points(mesh, {.fraction = 0.05}).points) {
    EXPECT_TRUE(std::is_sorted(c.region.begin(), c.region.end()));
    EXPECT_TRUE(std::binary_search(c.region.begin(), c.region.end(), c.vertex));
    for (const int v : c.region) {
      ++owners[v];
      EXPECT_LE((mesh.point(v) - mesh.point(c.vertex)).norm(), c.radius) << "vertex " << v;
    }
  }
  EXPECT_EQ(owners, std::vector<int>(mesh.vertex_count(), 1));
}

TEST(CriticalPoints, DoNotDependOnScalePlaceOrNumbering) {
  const TriMesh mesh = uneven_bumpy_sphere(12);
  const std::vector<int> expected = vertices_of(find_critical_points(mesh));
  ASSERT_GT(expected.size(), 10U);

  Points moved;
  for (const Vec3& p : mesh.points()) moved.push_back(1e4 * Vec3(p.y(), p.z(), p.x()) + Vec3(3, 2, 1));
  EXPECT_EQ(vertices_of(find_critical_points(mesh.with_points(moved))), expected);

  std::vector<int> new_index(mesh.vertex_count());
  for (int v = 0; v < mesh.vertex_count(); ++v) new_index[v] = v;
  std::shuffle(new_index.begin(), new_index.end(), std::mt19937(7));
  Points points(mesh.vertex_count());
  for (int v = 0; v < mesh.vertex_count(); ++v) points[new_index[v]] = mesh.point(v);
  Facets facets = mesh.facets();
  for (Facet& f : facets) {
    for (int& v : f) v = new_index[v];
  }
  std::reverse(facets.begin(), facets.end());
  std::vector<int> renumbered = expected;
  for (int& v : renumbered) v = new_index[v];
  EXPECT_EQ(vertices_of(find_critical_points(TriMesh(points, facets))), renumbered);
}

TEST(CriticalPoints, OfAPlaneAreFew) {
  EXPECT_LE(find_critical_points(tests::grid(20), {.fraction = 1}).points.size(), 100U);
}

TEST(CriticalPoints, RefuseOptionsOutOfRange) {
  const TriMesh mesh = tests::tetrahedron();
  EXPECT_THROW(find_critical_points(mesh, {.fraction = 0}), InputError);
  EXPECT_THROW(find_critical_points(mesh, {.fraction = 1.5}), InputError);
  EXPECT_THROW(find_critical_points(mesh, {.count = -1}), InputError);
  EXPECT_EQ(find_critical_points(mesh, {.count = 1}).points.size(), 1U);
}

}  // namespace
}  // namespace partwise
