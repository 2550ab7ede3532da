#include "segmentation/screen_stroke.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "builders.h"
#include "segmentation/sketches.h"

namespace partwise {
namespace {

/// Looks down the z axis from z = 10 with 60 degrees of vertical view; 800 x 600 pixels.
Camera from_above() {
  Camera camera;
  camera.view(2, 3) = -10;
  const double f = 1 / std::tan(std::acos(-1.0) / 6), near = 1, far = 100;
  camera.projection << f * 600 / 800, 0, 0, 0,                           //
      0, f, 0, 0,                                                        //
      0, 0, (far + near) / (near - far), 2 * far * near / (near - far),  //
      0, 0, -1, 0;
  camera.width = 800;
  camera.height = 600;
  return camera;
}

/// Pixel at which the camera sees a point: x to the right, y down.
Eigen::Vector2d pixel(const Camera& camera, const Vec3& point) {
  const Vec3 ndc = (camera.projection * camera.view * point.homogeneous()).hnormalized();
  return {(ndc.x() + 1) / 2 * camera.width, (1 - ndc.y()) / 2 * camera.height};
}

void expect_chain(const TriMesh& mesh, const std::vector<int>& vertices) {
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    EXPECT_TRUE(
        mesh.half_edges()
            .find_halfedge(OpenMesh::VertexHandle(vertices[i - 1]), OpenMesh::VertexHandle(vertices[i]))
            .is_valid());
  }
}

TEST(ScreenStroke, HitsTheVisibleSideUnderItsPixels) {
  const TriMesh mesh = tests::sphere(24);
  const SurfaceIndex index(mesh);
  const Camera camera = from_above();
  const Vec3 a(0, 0, 1), b = Vec3(0.5, 0.5, 1).normalized();
  const std::vector<int> vertices =
      project_stroke(mesh, index, {{pixel(camera, a), pixel(camera, b)}, camera});
  ASSERT_GT(vertices.size(), 5U);
  EXPECT_EQ(vertices.front(), tests::vertex_near(mesh, a));
  EXPECT_LT((mesh.point(vertices.back()) - b).norm(), 0.1);
  for (const int v : vertices) {
    EXPECT_GT(mesh.point(v).z(), 0);
    EXPECT_NEAR(mesh.point(v).x(), mesh.point(v).y(), 0.1);  // y is up in space, down on the screen
    EXPECT_GT(mesh.point(v).y(), -0.05);
  }
  expect_chain(mesh, vertices);
}

TEST(ScreenStroke, BridgesGapsAlongTheSurface) {
  // Straight across the hole of a torus: the way leads around it along the surface.
  const TriMesh mesh = tests::torus(2, 0.6, 48, 20);
  const SurfaceIndex index(mesh);
  const Camera camera = from_above();
  const std::vector<int> vertices =
      project_stroke(mesh, index, {{pixel(camera, {-2, 0, 0.6}), pixel(camera, {2, 0, 0.6})}, camera});
  expect_chain(mesh, vertices);
  EXPECT_LT(mesh.point(vertices.front()).x(), -1.8);
  EXPECT_GT(mesh.point(vertices.back()).x(), 1.8);
}

TEST(ScreenStroke, DirectionDoesNotMatterWhereAllSamplesHit) {
  const TriMesh mesh = tests::irregular_body();
  const SurfaceIndex index(mesh);
  const Camera camera = from_above();
  std::vector<Eigen::Vector2d> way{pixel(camera, {0, 0, 1.7}), pixel(camera, {0.2, 0.1, 1.7})};
  const std::vector<int> there = project_stroke(mesh, index, {way, camera});
  std::swap(way[0], way[1]);
  const std::vector<int> back = project_stroke(mesh, index, {way, camera});
  EXPECT_EQ(std::set<int>(there.begin(), there.end()), std::set<int>(back.begin(), back.end()));
}

TEST(ScreenStroke, IsEmptyBesideTheMesh) {
  const TriMesh mesh = tests::sphere(4);
  EXPECT_TRUE(project_stroke(mesh, SurfaceIndex(mesh), {{{1, 1}, {30, 1}}, from_above()}).empty());
}

TEST(ShortestEdgePath, TakesTheShortestWay) {
  const TriMesh mesh = tests::grid(4);  // vertex 5 i + j; diagonals lead from (i, j) to (i + 1, j + 1)
  EXPECT_EQ(shortest_edge_path(mesh, 0, 24), (std::vector<int>{0, 6, 12, 18, 24}));
  EXPECT_EQ(shortest_edge_path(mesh, 7, 7), (std::vector<int>{7}));
}

}  // namespace
}  // namespace partwise
