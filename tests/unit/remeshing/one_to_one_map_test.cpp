#include "remeshing/one_to_one_map.h"

#include <gtest/gtest.h>

#include "builders.h"
#include "convex_pairs.h"
#include "mapping/build_hulls.h"
#include "mapping/hull_to_hull.h"
#include "mapping/map_to_hull.h"
#include "measure/certificate.h"
#include "remeshing/reconstruct.h"
#include "remeshing/relocate.h"

namespace partwise {
namespace {

/// A torus around the z axis in two halves that meet twice.
SegmentedModel half_tori(const TriMesh& mesh) {
  std::vector<int> labels;
  for (const Facet& f : mesh.facets()) {
    labels.push_back(mesh.point(f[0]).x() + mesh.point(f[1]).x() + mesh.point(f[2]).x() > 0 ? 1 : 0);
  }
  return {mesh, trace_boundaries(mesh, {"left", "right"}, labels), {}, {}, {}};
}

CompatibleMesh torus_pair() {
  auto on_hulls = [](const TriMesh& mesh) { return map_to_hull(build_hulls(half_tori(mesh))).map; };
  return reconstruct(
             map_hull_to_hull(on_hulls(tests::torus(1, 0.3, 20, 10)), on_hulls(tests::torus(1, 0.45, 24, 14)))
                 .map)
      .mesh;
}

void expect_inverse(const CompatibleMesh& mesh) {
  ASSERT_EQ(static_cast<int>(mesh.inverse.size()), mesh.target.vertex_count());
  // Back and forth: a source vertex at a target vertex is that vertex's inverse.
  for (int v = 0; v < mesh.source.vertex_count(); ++v) {
    const SurfacePoint& image = mesh.map[v];
    int corner = 0;
    if (image.barycentric.maxCoeff(&corner) < 1) continue;
    const SurfacePoint& back = mesh.inverse[mesh.target.facet(image.facet)[corner]];
    EXPECT_LT((position(mesh.source, back) - mesh.source.point(v)).norm(), 1e-9 * mesh.source.diagonal());
  }
}

TEST(OneToOneMap, OnASphereHasOneChartWithoutAddedVertices) {
  const CompatibleMesh mesh =
      reconstruct(tests::projected_pair(tests::halves(tests::cube(6)), tests::halves(tests::sphere(9)))).mesh;
  ASSERT_EQ(mesh.charts.size(), 1U);
  EXPECT_TRUE(mesh.added_vertices.empty());
  EXPECT_TRUE(certify(mesh).one_to_one());
  expect_inverse(mesh);
}

TEST(OneToOneMap, OntoItselfIsItsOwnInverse) {
  const SegmentedModel model = tests::halves(tests::bumpy_sphere(8, 0.3));
  const CompatibleMesh mesh = reconstruct(tests::projected_pair(model, model)).mesh;
  expect_inverse(mesh);
  for (int v = 0; v < mesh.target.vertex_count(); ++v) {
    EXPECT_LT((position(mesh.source, mesh.inverse[v]) - mesh.target.point(v)).norm(), 1e-9);
  }
}

TEST(OneToOneMap, OfATorusIsPartByPartWithOneCommonBoundary) {
  const CompatibleMesh mesh = torus_pair();
  ASSERT_EQ(mesh.charts.size(), 2U);
  // The target's loops have more vertices than the source's.
  EXPECT_GE(mesh.added_vertices.size(), 8U);
  const Certificate found = certify(mesh);
  EXPECT_TRUE(found.one_to_one()) << found.first_reason();
  expect_inverse(mesh);
}

TEST(OneToOneMap, ABoundaryThatMissesTheTargetsIsNoCertificate) {
  CompatibleMesh mesh = torus_pair();
  mesh.added_vertices.erase(mesh.added_vertices.begin());
  EXPECT_FALSE(certify(mesh).one_to_one());
}

TEST(OneToOneMap, RelocateKeepsIt) {
  for (const CompatibleMesh& mesh :
       {torus_pair(), reconstruct(tests::projected_pair(tests::halves(tests::cube(6)),
                                                        tests::halves(tests::bumpy_sphere(9, 0.3))))
                          .mesh}) {
    const Relocation moved = relocate(mesh);
    EXPECT_NE(moved.mesh.points, mesh.points);
    EXPECT_TRUE(certify(moved.mesh).one_to_one()) << certify(moved.mesh).first_reason();
    for (const ChartFigures& chart : moved.metrics.charts) EXPECT_TRUE(chart.one_to_one) << chart.reason;
    expect_inverse(moved.mesh);
  }
}

TEST(OneToOneMap, FoldsAreUndoneAndCounted) {
  CompatibleMesh mesh =
      reconstruct(tests::projected_pair(tests::whole(tests::cube(8)), tests::whole(tests::sphere(12))),
                  {.one_to_one = false})
          .mesh;
  EXPECT_TRUE(mesh.charts.empty());
  std::vector<SurfacePoint> images = mesh.map.images();
  std::swap(images[mesh.source.facet(50)[0]], images[mesh.source.facet(50)[1]]);
  mesh.map = SurfaceMap(mesh.source, mesh.target, images);
  const OneToOneMap found = make_one_to_one(mesh, {});
  ASSERT_EQ(found.charts.size(), 1U);
  EXPECT_GT(found.charts[0].folds_before, 0);
  EXPECT_EQ(found.charts[0].folds, 0);
  EXPECT_GT(found.moved_vertices, 0);
  EXPECT_LT(found.moved_vertices, mesh.source.vertex_count() / 3) << "only what is near the fold moves";
  EXPECT_TRUE(certify(found.mesh).one_to_one());
}

TEST(OneToOneMap, AHandleInsideAPartIsNamed) {
  CompatibleMesh mesh = torus_pair();
  mesh.charts.clear();
  mesh.added_vertices.clear();
  mesh.part_names = {"all", "none"};
  for (int& label : mesh.source_labels) label = 0;
  for (int& label : mesh.target_labels) label = 0;
  const Part piece = extract_piece(mesh.target, std::vector<bool>(mesh.target.facet_count(), true));
  const OneToOneMap found = make_one_to_one(mesh, {{{0}, piece.mesh.points()}});
  EXPECT_FALSE(found.one_to_one());
  EXPECT_NE(found.charts.at(0).reason.find("handle"), std::string::npos);
  EXPECT_TRUE(found.mesh.charts.empty());
}

}  // namespace
}  // namespace partwise
