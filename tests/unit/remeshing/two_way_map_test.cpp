#include "remeshing/two_way_map.h"

#include <gtest/gtest.h>

#include "builders.h"
#include "convex_pairs.h"
#include "mapping/build_hulls.h"
#include "mapping/hull_to_hull.h"
#include "mapping/map_to_hull.h"
#include "remeshing/reconstruct.h"

namespace partwise {
namespace {

void expect_back_and_forth(const CompatibleMesh& mesh) {
  const TwoWayMap map(mesh);
  ASSERT_TRUE(map.one_to_one());
  for (int f = 0; f < mesh.source.facet_count(); ++f) {
    const SurfacePoint start{f, Vec3(0.2, 0.3, 0.5)};
    const SurfacePoint back = map.to_source(map.to_target(start));
    EXPECT_LT((position(mesh.source, back) - position(mesh.source, start)).norm(), 1e-9) << "facet " << f;
  }
  for (int f = 0; f < mesh.target.facet_count(); ++f) {
    const SurfacePoint start{f, Vec3(0.6, 0.3, 0.1)};
    const SurfacePoint back = map.to_target(map.to_source(start));
    EXPECT_LT((position(mesh.target, back) - position(mesh.target, start)).norm(), 1e-9) << "facet " << f;
  }
}

TEST(TwoWayMap, OnOneChartBackAndForthIsNothing) {
  expect_back_and_forth(
      reconstruct(tests::projected_pair(tests::halves(tests::cube(6)), tests::halves(tests::sphere(9))))
          .mesh);
}

TEST(TwoWayMap, OnManyChartsWithAddedVerticesToo) {
  auto on_hulls = [](const TriMesh& mesh) {
    std::vector<int> labels;
    for (const Facet& f : mesh.facets()) {
      labels.push_back(mesh.point(f[0]).x() + mesh.point(f[1]).x() + mesh.point(f[2]).x() > 0 ? 1 : 0);
    }
    const SegmentedModel model{mesh, trace_boundaries(mesh, {"left", "right"}, labels), {}, {}, {}};
    return map_to_hull(build_hulls(model)).map;
  };
  const CompatibleMesh mesh = reconstruct(map_hull_to_hull(on_hulls(tests::torus(1, 0.3, 20, 10)),
                                                           on_hulls(tests::torus(1, 0.45, 24, 14)))
                                              .map)
                                  .mesh;
  ASSERT_FALSE(mesh.added_vertices.empty());
  expect_back_and_forth(mesh);
}

TEST(TwoWayMap, AgreesWithTheMapOfVertices) {
  const CompatibleMesh mesh =
      reconstruct(tests::projected_pair(tests::halves(tests::cube(4)), tests::halves(tests::sphere(7)))).mesh;
  const TwoWayMap map(mesh);
  for (int f = 0; f < mesh.source.facet_count(); ++f) {
    for (int i = 0; i < 3; ++i) {
      const SurfacePoint there = map.to_target({f, Vec3::Unit(i)});
      EXPECT_LT((position(mesh.target, there) - mesh.points[mesh.source.facet(f)[i]]).norm(), 1e-9);
    }
  }
}

TEST(TwoWayMap, WithoutChartsTheClosestPointsServe) {
  CompatibleMesh mesh =
      reconstruct(tests::projected_pair(tests::halves(tests::sphere(8)), tests::halves(tests::sphere(8))))
          .mesh;
  mesh.charts.clear();
  mesh.inverse.clear();
  const TwoWayMap map(mesh);
  EXPECT_FALSE(map.one_to_one());
  for (int v = 0; v < mesh.target.vertex_count(); ++v) {
    EXPECT_LT((position(mesh.source, map.vertex_to_source(v)) - mesh.target.point(v)).norm(), 1e-6);
  }
  const SurfacePoint there = map.to_target({5, Vec3(0.2, 0.3, 0.5)});
  EXPECT_LT((position(mesh.target, there) - position(mesh.source, {5, Vec3(0.2, 0.3, 0.5)})).norm(), 1e-6);
}

}  // namespace
}  // namespace partwise
