#include "segmentation/suggest_sketch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "builders.h"
#include "error.h"
#include "segmentation/edge_distances.h"
#include "segmentation/segment_mesh.h"
#include "segmentation/sketches.h"

namespace partwise {
namespace {

/// A ball with six arms along the axes.
TriMesh jack() {
  return tests::bumpy_sphere(24, 2.5);
}

TEST(EdgeDistances, AreLengthsAlongEdges) {
  const TriMesh grid = tests::grid(4);  // squares of side 0.5
  const int corner = tests::vertex_near(grid, {-1, -1, 0}), beside = tests::vertex_near(grid, {1, -1, 0});
  const EdgeDistances ways = edge_distances(grid, {corner}, {});
  EXPECT_DOUBLE_EQ(ways.distance[beside], 2);
  EXPECT_EQ(ways.way_back(beside).size(), 5U);
  EXPECT_EQ(ways.way_back(beside).back(), corner);
  EXPECT_GE(ways.distance[ways.farthest()], 2);
  std::vector<bool> may_pass(grid.vertex_count());
  for (int v = 0; v < grid.vertex_count(); ++v) may_pass[v] = grid.point(v).x() < 0.1;
  const EdgeDistances walled = edge_distances(grid, {corner}, may_pass);
  EXPECT_TRUE(std::isinf(walled.distance[beside]));
  EXPECT_LT(grid.point(walled.farthest()).x(), 0.1);
}

TEST(SuggestSketch, FindsTheArmsOfAStar) {
  const TriMesh mesh = jack();
  const Sketch sketch = suggest_sketch(mesh, 7);
  ASSERT_EQ(sketch.parts.size(), 7U);
  EXPECT_EQ(sketch.parts[0].name, "core");
  EXPECT_EQ(sketch.parts[6].name, "part 6");
  std::set<int> tips;
  for (std::size_t part = 1; part < 7; ++part) {
    const int tip = std::get<VertexStroke>(sketch.parts[part].strokes[0]).vertices.front();
    EXPECT_GT(mesh.point(tip).norm(), 3) << part;
    tips.insert(tip);
  }
  EXPECT_EQ(tips.size(), 6U);
  ASSERT_TRUE(sketch.mesh);
  EXPECT_EQ(sketch.mesh->vertices, mesh.vertex_count());
  const SegmentedMesh segmented = segment_mesh(mesh, sketch, {});
  EXPECT_EQ(segmented.model.segmentation.part_count(), 7);
}

TEST(SuggestSketch, DoesNotChangeWithScaleAndRotation) {
  const TriMesh body = tests::irregular_body();
  Points points = body.points();
  const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, -1).normalized());
  for (Vec3& p : points) p = 1000 * (turn * p) + Vec3(5, 6, 7);
  const Sketch plain = suggest_sketch(body, 3), moved = suggest_sketch(body.with_points(points), 3);
  for (std::size_t part = 0; part < 3; ++part) {
    EXPECT_EQ(std::get<VertexStroke>(plain.parts[part].strokes[0]).vertices,
              std::get<VertexStroke>(moved.parts[part].strokes[0]).vertices);
  }
}

TEST(SuggestSketch, RefusesSeveralComponents) {
  const TriMesh one = tests::sphere(4);
  Points points = one.points();
  Facets facets = one.facets();
  for (const Vec3& p : one.points()) points.push_back(p + Vec3(5, 0, 0));
  const int n = one.vertex_count();
  for (const auto& [a, b, c] : one.facets()) facets.push_back({a + n, b + n, c + n});
  EXPECT_THROW(suggest_sketch(TriMesh(std::move(points), std::move(facets)), 3), InputError);
}

}  // namespace
}  // namespace partwise
