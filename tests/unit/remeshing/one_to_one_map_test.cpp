#include "remeshing/one_to_one_map.h"

#include <gtest/gtest.h>

#include "builders.h"
#include "convex_pairs.h"
#include "mapped_pairs.h"
#include "measure/certificate.h"
#include "remeshing/reconstruct.h"
#include "remeshing/relocate.h"

namespace partwise {
namespace {

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
  const CompatibleMesh mesh = tests::torus_pair();
  ASSERT_EQ(mesh.charts.size(), 2U);
  // The target's loops have more vertices than the source's.
  EXPECT_GE(mesh.added_vertices.size(), 8U);
  const Certificate found = certify(mesh);
  EXPECT_TRUE(found.one_to_one()) << found.first_reason();
  expect_inverse(mesh);
}

TEST(OneToOneMap, ABoundaryThatMissesTheTargetsIsNoCertificate) {
  CompatibleMesh mesh = tests::torus_pair();
  mesh.added_vertices.erase(mesh.added_vertices.begin());
  EXPECT_FALSE(certify(mesh).one_to_one());
}

TEST(OneToOneMap, RelocateKeepsIt) {
  for (const CompatibleMesh& mesh :
       {tests::torus_pair(), reconstruct(tests::projected_pair(tests::halves(tests::cube(6)),
                                                               tests::halves(tests::bumpy_sphere(9, 0.3))))
                                 .mesh}) {
    const Relocation moved = relocate(mesh);
    EXPECT_NE(moved.mesh.points, mesh.points);
    EXPECT_TRUE(certify(moved.mesh).one_to_one()) << certify(moved.mesh).first_reason();
    for (const ChartFigures& chart : moved.metrics.charts) EXPECT_TRUE(chart.one_to_one) << chart.reason;
    expect_inverse(moved.mesh);
  }
}

/// Per vertex: number of edges to the nearest of `from`.
std::vector<int> edges_away(const TriMesh& mesh, std::vector<int> from) {
  std::vector<int> distance(mesh.vertex_count(), -1);
  for (const int v : from) distance[v] = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    for (const auto w : mesh.half_edges().vv_range(OpenMesh::VertexHandle(from[i]))) {
      if (distance[w.idx()] >= 0) continue;
      distance[w.idx()] = distance[from[i]] + 1;
      from.push_back(w.idx());
    }
  }
  return distance;
}

TEST(OneToOneMap, FoldsAreUndoneAndWhatIsFarFromThemStays) {
  CompatibleMesh mesh =
      reconstruct(tests::projected_pair(tests::whole(tests::cube(8)), tests::whole(tests::sphere(12))),
                  {.one_to_one = false})
          .mesh;
  EXPECT_TRUE(mesh.charts.empty());
  std::vector<SurfacePoint> images = mesh.map.images();
  const int a = mesh.source.facet(50)[0], b = mesh.source.facet(50)[1];
  std::swap(images[a], images[b]);
  mesh.map = SurfaceMap(mesh.source, mesh.target, images);
  const OneToOneMap found = make_one_to_one(mesh, {});
  ASSERT_EQ(found.charts.size(), 1U);
  EXPECT_EQ(found.charts[0].folds_before, 2) << "the facets on both sides of the edge that is turned round";
  EXPECT_EQ(found.charts[0].folds, 0);
  EXPECT_TRUE(certify(found.mesh).one_to_one());
  const std::vector<int> away = edges_away(mesh.source, {a, b});
  int moved = 0;
  for (int v = 0; v < mesh.source.vertex_count(); ++v) {
    const SurfacePoint& image = found.mesh.map[v];
    if (image.facet == images[v].facet && image.barycentric == images[v].barycentric) continue;
    ++moved;
    EXPECT_LE(away[v], 3) << "two rings around the two facets may move, vertex " << v;
  }
  EXPECT_EQ(found.moved_vertices, moved);
  EXPECT_GE(moved, 1);
}

/// The vertex of a mesh around the origin that lies nearest to a direction.
SurfacePoint vertex_towards(const TriMesh& mesh, const Vec3& direction) {
  SurfacePoint nearest;
  double most = -1;
  for (int f = 0; f < mesh.facet_count(); ++f) {
    for (int i = 0; i < 3; ++i) {
      const double along = mesh.point(mesh.facet(f)[i]).normalized().dot(direction.normalized());
      if (along <= most) continue;
      most = along;
      nearest = {f, Vec3::Unit(i)};
    }
  }
  return nearest;
}

TEST(OneToOneMap, AMarkerBeyondItsPartsBoundaryIsPlacedOnTheWholeSurface) {
  const TriMesh cube = tests::cube(6), sphere = tests::sphere(9);
  const MarkerPair marker{"m", vertex_towards(cube, {1, 0, 0.33}), vertex_towards(sphere, {1, 0, -0.2})};
  const CompatibleMesh before =
      reconstruct(tests::projected_pair(tests::halves(cube), tests::halves(sphere), {marker}),
                  {.one_to_one = false})
          .mesh;
  const int v = *vertex_at(cube, marker.source);
  ASSERT_GT((before.points[v] - position(sphere, marker.target)).norm(), 0.2);
  const OneToOneMap found = make_one_to_one(before, {});
  EXPECT_TRUE(certify(found.mesh).one_to_one());
  EXPECT_EQ(found.placed_markers, std::vector<std::string>{"m"});
  EXPECT_FALSE(found.curves_held);
  EXPECT_EQ(found.mesh.points[v], position(sphere, marker.target));
}

/// A cube with flat facets and a sphere with needles, in halves, both with a tiny opening.
Reconstruction with_slivers(const Vec3& opening) {
  constexpr double kTiny = 1e-6;
  return tests::mapped_by_hulls(
      tests::halves(tests::with_opening(tests::with_flat_slivers(tests::cube(4), 3, kTiny), opening, kTiny)),
      tests::halves(tests::with_opening(tests::with_needles(tests::sphere(5), 4, kTiny), opening, kTiny)));
}

TEST(OneToOneMap, SliversAndATinyOpeningInBothModels) {
  const Reconstruction found = with_slivers({-0.5, 0.4, 0.8});
  EXPECT_TRUE(certify(found.mesh).one_to_one()) << certify(found.mesh).first_reason();
  const Relocation moved = relocate(found.mesh);
  EXPECT_TRUE(certify(moved.mesh).one_to_one()) << certify(moved.mesh).first_reason();
}

TEST(OneToOneMap, AnOpeningInASliverIsNamedWhenItCannotBeMapped) {
  // The opening is a needle on the target: its three corners fall on one edge of the source's opening.
  const Reconstruction found = with_slivers({0.2, 0.3, 1});
  ASSERT_FALSE(certify(found.mesh).one_to_one());
  ASSERT_EQ(found.metrics.charts.size(), 2U);
  EXPECT_TRUE(found.metrics.charts[0].one_to_one);
  EXPECT_NE(found.metrics.charts[1].reason.find("facets stay folded"), std::string::npos);
}

TEST(OneToOneMap, AHandleInsideAPartIsNamed) {
  CompatibleMesh mesh = tests::torus_pair();
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
