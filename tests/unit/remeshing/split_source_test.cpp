#include "remeshing/split_source.h"

#include <gtest/gtest.h>

#include "builders.h"
#include "convex_pairs.h"
#include "error.h"
#include "geometry/normals.h"
#include "mapped_pairs.h"
#include "measure/certificate.h"
#include "remeshing/one_to_one_map.h"
#include "remeshing/reconstruct.h"

namespace partwise {
namespace {

/// Every `every`-th edge that can be cut, at a third.
std::vector<EdgePoint> some_edges(const CompatibleMesh& mesh, int every) {
  const std::vector<bool> splittable = splittable_edges(mesh);
  std::vector<EdgePoint> places;
  for (const auto e : mesh.source.half_edges().edges()) {
    if (splittable[e.idx()] && e.idx() % every == 0) places.push_back({e.v0().idx(), e.v1().idx(), 1.0 / 3});
  }
  return places;
}

CompatibleMesh cube_on_bumps() {
  MarkerPair marker{"m", {17, Vec3(0.2, 0.3, 0.5)}, {40, Vec3(0.5, 0.25, 0.25)}};
  return reconstruct(tests::projected_pair(tests::whole(tests::cube(5)),
                                           tests::whole(tests::bumpy_sphere(10, 0.3)), {marker}))
      .mesh;
}

double area(const TriMesh& mesh) {
  double sum = 0;
  for (const double a : facet_areas(mesh.points(), mesh.facets())) sum += a;
  return sum;
}

TEST(SplitSource, KeepsTheSurfaceItsVerticesAndTheMap) {
  const CompatibleMesh mesh = cube_on_bumps();
  CompatibleMesh split = mesh;
  for (const int every : {2, 3, 5}) split = split_source(split, some_edges(split, every));
  const int originals = mesh.source.vertex_count();
  ASSERT_GT(split.source.vertex_count(), 3 * originals);
  EXPECT_NEAR(area(split.source), area(mesh.source), 1e-12 * area(mesh.source));
  for (int v = 0; v < originals; ++v) {
    EXPECT_EQ(split.source.point(v), mesh.source.point(v));
    EXPECT_EQ(split.points[v], mesh.points[v]);
  }
  EXPECT_EQ(original_source(split).facets(), mesh.source.facets());
  EXPECT_EQ(original_source(split).points(), mesh.source.points());
  EXPECT_TRUE(certify(split).one_to_one()) << certify(split).first_reason();
  EXPECT_LT((position(split.source, split.markers[0].source) - position(mesh.source, mesh.markers[0].source))
                .norm(),
            1e-12);
}

TEST(SplitSource, SaysWhereVerticesComeFrom) {
  const CompatibleMesh mesh = cube_on_bumps();
  CompatibleMesh split = split_source(mesh, some_edges(mesh, 2));
  split = split_source(split, some_edges(split, 2));
  const int originals = mesh.source.vertex_count();
  ASSERT_EQ(static_cast<int>(split.refinement.vertices.size()), split.source.vertex_count() - originals);
  for (std::size_t i = 0; i < split.refinement.vertices.size(); ++i) {
    const Vec3 there = position(mesh.source, split.refinement.vertices[i]);
    EXPECT_LT((there - split.source.point(originals + static_cast<int>(i))).norm(), 1e-12);
  }
  for (int f = 0; f < split.source.facet_count(); ++f) {
    const int parent = split.refinement.parent_facet[f];
    EXPECT_EQ(split.source_labels[f], mesh.source_labels[parent]);
    const auto& [a, b, c] = split.source.facet(f);
    const Vec3 middle = (split.source.point(a) + split.source.point(b) + split.source.point(c)) / 3;
    const Facet& corners = mesh.source.facet(parent);
    const Vec3 normal = area_vector(mesh.source.point(corners[0]), mesh.source.point(corners[1]),
                                    mesh.source.point(corners[2]));
    EXPECT_NEAR(normal.dot(middle - mesh.source.point(corners[0])), 0, 1e-12);
  }
}

TEST(SplitSource, NewVerticesGoWhereTheInverseComesFrom) {
  const CompatibleMesh mesh = cube_on_bumps();
  CompatibleMesh split = split_source(mesh, some_edges(mesh, 2));
  // A target vertex on an old edge's image is rare; the facets that the map takes to it stay the same.
  const std::vector<SurfacePoint> again = inverse_map(split);
  int same = 0;
  for (std::size_t v = 0; v < again.size(); ++v) {
    same += split.refinement.parent_facet[again[v].facet] == mesh.inverse[v].facet;
  }
  EXPECT_GT(same, 0.98 * static_cast<double>(again.size()));
}

TEST(SplitSource, LeavesBoundariesOfChartsAlone) {
  const CompatibleMesh mesh = tests::torus_pair();
  ASSERT_EQ(mesh.charts.size(), 2U);
  ASSERT_FALSE(mesh.added_vertices.empty());
  const CompatibleMesh split = split_source(mesh, some_edges(mesh, 1));
  EXPECT_GT(split.refinement.vertices.size(), 100U);
  EXPECT_TRUE(certify(split).one_to_one()) << certify(split).first_reason();
  const EdgePoint& held = mesh.added_vertices.front().place;
  EXPECT_THROW(split_source(mesh, {{held.a, held.b, 0.5}}), InputError);
}

TEST(SplitSource, WorksWithoutCharts) {
  CompatibleMesh mesh = cube_on_bumps();
  mesh.charts.clear();
  mesh.inverse.clear();
  const CompatibleMesh split = split_source(mesh, some_edges(mesh, 3));
  EXPECT_GT(split.source.vertex_count(), mesh.source.vertex_count());
  EXPECT_TRUE(split.inverse.empty());
}

TEST(SplitSource, RefusesWhatIsNoEdge) {
  const CompatibleMesh mesh = cube_on_bumps();
  EXPECT_THROW(split_source(mesh, {{0, 0, 0.5}}), InputError);
  const Facet& f = mesh.source.facet(0);
  EXPECT_THROW(split_source(mesh, {{f[0], f[1], 1}}), InputError);
}

}  // namespace
}  // namespace partwise
