#include <gtest/gtest.h>

#include "builders.h"
#include "measure/flipped_facets.h"
#include "measure/self_intersections.h"

namespace partwise {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

SurfaceMap identity_map(const TriMesh& mesh) {
  std::vector<SurfacePoint> images(mesh.vertex_count());
  for (int f = 0; f < mesh.facet_count(); ++f) {
    for (int i = 0; i < 3; ++i) images[mesh.facet(f)[i]] = {f, Vec3::Unit(i)};
  }
  return SurfaceMap(mesh, mesh, images);
}

TEST(FlippedFacets, NoneInTheIdentity) {
  for (const TriMesh& mesh : {tests::cube(3), tests::torus(3, 1, 20, 8), tests::grid(4)}) {
    EXPECT_TRUE(flipped_facets(mesh.points(), mesh.facets(), identity_map(mesh), mesh).empty());
  }
}

TEST(FlippedFacets, AVertexPushedOverItsRingTurnsTheFacetThere) {
  // The ring of the middle vertex is a hexagon; past its edge y = x + 1 the facet at that edge turns over.
  const TriMesh grid = tests::grid(2);
  std::vector<SurfacePoint> images = identity_map(grid).images();
  Points points = grid.points();
  points[4] = Vec3(0.25, 0.75, 0);
  EXPECT_TRUE(flipped_facets(points, grid.facets(), SurfaceMap(grid, grid, images), grid).empty());
  points[4] = Vec3(-0.5, 0.75, 0);
  const std::vector<int> flipped =
      flipped_facets(points, grid.facets(), SurfaceMap(grid, grid, images), grid);
  ASSERT_EQ(flipped.size(), 1U);
  const Facet& f = grid.facet(flipped.front());
  EXPECT_LT(((points[f[1]] - points[f[0]]).cross(points[f[2]] - points[f[0]])).z(), 0);
}

TEST(FlippedFacets, AllWhenTheSurfaceIsInsideOut) {
  const TriMesh sphere = tests::sphere(4);
  Facets inside_out;
  for (const auto& [a, b, c] : sphere.facets()) inside_out.push_back({a, c, b});
  EXPECT_EQ(flipped_facets(sphere.points(), inside_out, identity_map(sphere), sphere).size(), 128U);
}

TEST(SelfIntersections, NoneInCleanMeshes) {
  for (const TriMesh& mesh : {tests::cube(4), tests::sphere(6), tests::torus(3, 1, 20, 8), tests::grid(4)}) {
    EXPECT_EQ(self_intersections(mesh.points(), mesh.facets()), Pairs{});
  }
}

TEST(SelfIntersections, TwoCrossingTrianglesAreOnePair) {
  const Points points{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}, {0, -3, 0}};
  EXPECT_EQ(self_intersections(points, {{0, 1, 2}, {3, 4, 5}}), (Pairs{{0, 1}}));
}

TEST(SelfIntersections, TrianglesApartAreNone) {
  const Points points{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {-1, -1, 1e-12}, {1, -1, 1e-12}, {0, 1, 1e-12}};
  EXPECT_EQ(self_intersections(points, {{0, 1, 2}, {3, 4, 5}}), Pairs{});
}

TEST(SelfIntersections, NeighboursOverAVertexCountOnlyWhenTheyCross) {
  const Points points{{0, 0, 0}, {1, -1, 0}, {1, 1, 0}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}};
  EXPECT_EQ(self_intersections(points, {{0, 1, 2}, {0, 3, 4}}), (Pairs{{0, 1}}));
  EXPECT_EQ(self_intersections(points, {{0, 1, 2}, {0, 4, 5}}), Pairs{});
}

TEST(SelfIntersections, NeighboursOverAnEdgeCountWhenFoldedFlat) {
  const Points points{{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 0.5, 0}, {0.5, -1, 0}, {0.5, 0.5, 1e-9}};
  EXPECT_EQ(self_intersections(points, {{0, 1, 2}, {1, 0, 3}}), (Pairs{{0, 1}}));
  EXPECT_EQ(self_intersections(points, {{0, 1, 2}, {1, 0, 4}}), Pairs{});
  EXPECT_EQ(self_intersections(points, {{0, 1, 2}, {1, 0, 5}}), Pairs{});
}

TEST(SelfIntersections, FacetsWithoutAreaHaveNone) {
  const Points points{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 0}, {0, 0, 1}};
  EXPECT_EQ(self_intersections(points, {{0, 1, 2}, {3, 4, 5}}), Pairs{});
}

}  // namespace
}  // namespace partwise
