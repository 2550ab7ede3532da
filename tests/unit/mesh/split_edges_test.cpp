#include "mesh/split_edges.h"

#include <gtest/gtest.h>

#include <set>

#include "builders.h"
#include "error.h"
#include "geometry/normals.h"

namespace partwise {
namespace {

const TriMesh& triangle() {
  static const TriMesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  return mesh;
}

double area(const TriMesh& mesh) {
  double sum = 0;
  for (const double a : facet_areas(mesh.points(), mesh.facets())) sum += a;
  return sum;
}

TEST(SplitEdges, NothingToSplitLeavesTheMesh) {
  const EdgeSplitMesh split = split_edges(tests::cube(3), {});
  EXPECT_EQ(split.mesh.facets(), tests::cube(3).facets());
  EXPECT_EQ(split.parent_facet.back(), split.mesh.facet_count() - 1);
}

TEST(SplitEdges, AFanAroundTheLastVertexThatCanBeOne) {
  // Vertex 3 on edge (0, 1), vertex 4 in the middle of (1, 2): all pieces have corner 4.
  const EdgeSplitMesh split = split_edges(triangle(), {{1, 0, 0.25}, {1, 2, 0.5}});
  EXPECT_EQ(split.mesh.point(3), Vec3(0.75, 0, 0));
  ASSERT_EQ(split.mesh.facet_count(), 3);
  for (const Facet& f : split.mesh.facets()) EXPECT_TRUE(std::set<int>(f.begin(), f.end()).contains(4));
}

/// Every number of vertices on every edge, in either direction: no piece is flat or turned over.
TEST(SplitEdges, AnyNumberOfPointsOnEveryEdge) {
  for (int counts = 0; counts < 64; ++counts) {
    std::vector<EdgePoint> points;
    for (int side = 0; side < 3; ++side) {
      const int count = counts >> (2 * side) & 3, a = side, b = (side + 1) % 3;
      for (int i = 1; i <= count; ++i) {
        const double fraction = i / (count + 1.0);
        points.push_back(i % 2 == 0 ? EdgePoint{a, b, fraction} : EdgePoint{b, a, 1 - fraction});
      }
    }
    const EdgeSplitMesh split = split_edges(triangle(), points);
    EXPECT_EQ(split.mesh.facet_count(), 1 + static_cast<int>(points.size()));
    EXPECT_NEAR(area(split.mesh), 0.5, 1e-15);
    for (const Facet& f : split.mesh.facets()) {
      EXPECT_GT(area_vector(split.mesh.point(f[0]), split.mesh.point(f[1]), split.mesh.point(f[2])).z(),
                0.01);
    }
  }
}

TEST(SplitEdges, PointsAreTheSameOnTheOriginal) {
  const TriMesh mesh = tests::bumpy_sphere(4, 0.3);
  std::vector<EdgePoint> points;
  for (int f = 0; f < mesh.facet_count(); f += 3) {
    const Facet& c = mesh.facet(f);
    if (c[0] < c[1]) points.push_back({c[0], c[1], 0.1 + 0.8 * f / mesh.facet_count()});
  }
  const EdgeSplitMesh split = split_edges(mesh, points);
  EXPECT_NEAR(area(split.mesh), area(mesh), 1e-12);
  for (int f = 0; f < split.mesh.facet_count(); ++f) {
    const SurfacePoint there{f, Vec3(0.2, 0.3, 0.5)};
    const SurfacePoint here = split.on_original(mesh, there);
    EXPECT_LT((position(mesh, here) - position(split.mesh, there)).norm(), 1e-15);
    EXPECT_NEAR(here.barycentric.sum(), 1, 1e-15);
  }
}

TEST(SplitEdges, RefusesWhatIsNoPointInsideAnEdge) {
  EXPECT_THROW(split_edges(triangle(), {{0, 3, 0.5}}), InputError);
  EXPECT_THROW(split_edges(triangle(), {{0, 0, 0.5}}), InputError);
  EXPECT_THROW(split_edges(triangle(), {{0, 1, 0}}), InputError);
  EXPECT_THROW(split_edges(triangle(), {{0, 1, 1}}), InputError);
  EXPECT_THROW(split_edges(triangle(), {{0, 1, 0.25}, {1, 0, 0.75}}), InputError);
  EXPECT_THROW(split_edges(tests::cube(2), {{0, 7, 0.5}}), InputError);
}

}  // namespace
}  // namespace partwise
