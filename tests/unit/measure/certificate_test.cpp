#include "measure/certificate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "builders.h"
#include "convex_pairs.h"
#include "remeshing/reconstruct.h"

namespace partwise {
namespace {

TEST(SphereCertificate, ConvexAndStarShapedSurfacesHaveIt) {
  for (const TriMesh& mesh : {tests::cube(3), tests::sphere(6), tests::bumpy_sphere(8, 0.3)}) {
    const SphereCertificate found = certify_sphere(mesh.facets(), mesh.points());
    EXPECT_TRUE(found.one_to_one()) << found.reason;
    EXPECT_EQ(found.degree, 1);
    EXPECT_EQ(found.folds, 0);
    EXPECT_EQ(found.euler_characteristic, 2);
  }
}

TEST(SphereCertificate, LengthsOfDirectionsDoNotMatter) {
  const TriMesh mesh = tests::sphere(6);
  Points directions = mesh.points();
  for (std::size_t v = 0; v < directions.size(); ++v)
    directions[v] *= std::pow(10.0, static_cast<int>(v % 9) - 4);
  EXPECT_TRUE(certify_sphere(mesh.facets(), directions).one_to_one());
}

TEST(SphereCertificate, AFoldIsCounted) {
  const TriMesh mesh = tests::sphere(6);
  Points directions = mesh.points();
  const int vertex = mesh.facet(40)[0];
  const auto ring = mesh.half_edges().vv_range(OpenMesh::VertexHandle(vertex));
  directions[vertex] += 2.2 * (directions[ring.begin()->idx()] - directions[vertex]);
  const SphereCertificate found = certify_sphere(mesh.facets(), directions);
  EXPECT_GT(found.folds, 0);
  EXPECT_NE(found.reason.find("positively"), std::string::npos);
}

TEST(SphereCertificate, AFacetWithoutAreaIsAFold) {
  const TriMesh mesh = tests::cube(2);
  Points directions = mesh.points();
  const Facet& f = mesh.facet(0);
  directions[f[0]] = (directions[f[1]] + directions[f[2]]) / 2;
  EXPECT_GT(certify_sphere(mesh.facets(), directions).folds, 0);
}

/// z -> z^2: twice around the axis, branching at the poles. No facet is folded, and counting folds alone
/// calls this perfect.
TEST(SphereCertificate, CoveringTwiceIsNone) {
  constexpr int kSegments = 12;
  Points directions{{0, 0, 1}, {0, 0, -1}};
  Facets facets;
  auto at = [](int ring, int segment) { return 2 + ring * kSegments + segment % kSegments; };
  for (int ring = 0; ring < 3; ++ring) {
    for (int segment = 0; segment < kSegments; ++segment) {
      const double angle = 2 * 2 * std::numbers::pi * (segment + ring / 2.0) / kSegments;
      directions.emplace_back(std::cos(angle), std::sin(angle), 1.0 - ring);
    }
  }
  for (int segment = 0; segment < kSegments; ++segment) {
    facets.push_back({0, at(0, segment), at(0, segment + 1)});
    facets.push_back({1, at(2, segment + 1), at(2, segment)});
    for (int ring = 0; ring < 2; ++ring) {
      facets.push_back({at(ring, segment), at(ring + 1, segment), at(ring, segment + 1)});
      facets.push_back({at(ring, segment + 1), at(ring + 1, segment), at(ring + 1, segment + 1)});
    }
  }
  const SphereCertificate found = certify_sphere(facets, directions);
  EXPECT_EQ(found.folds, 0);
  EXPECT_EQ(found.euler_characteristic, 2);
  EXPECT_EQ(found.degree, 2);
  EXPECT_NE(found.reason.find("2 times"), std::string::npos);
}

TEST(SphereCertificate, TwoSpheresAreNone) {
  const TriMesh mesh = tests::sphere(4);
  Points directions = mesh.points();
  Facets facets = mesh.facets();
  const int n = mesh.vertex_count();
  directions.insert(directions.end(), mesh.points().begin(), mesh.points().end());
  for (const Facet& f : mesh.facets()) facets.push_back({f[0] + n, f[1] + n, f[2] + n});
  EXPECT_NE(certify_sphere(facets, directions).reason.find("components"), std::string::npos);
}

TEST(SphereCertificate, TheInsideOutSphereIsAllFolds) {
  const TriMesh mesh = tests::sphere(4);
  Points directions = mesh.points();
  for (Vec3& d : directions) d = -d;
  EXPECT_EQ(certify_sphere(mesh.facets(), directions).folds, mesh.facet_count());
}

TEST(SphereCertificate, TopologyIsCheckedFirst) {
  TriMesh mesh = tests::sphere(4);
  Facets facets = mesh.facets();
  facets.pop_back();
  EXPECT_NE(certify_sphere(facets, mesh.points()).reason.find("closed"), std::string::npos);
  facets = mesh.facets();
  facets.push_back(facets.front());
  EXPECT_NE(certify_sphere(facets, mesh.points()).reason.find("more than two"), std::string::npos);
  const TriMesh torus = tests::torus(1, 0.4, 12, 8);
  EXPECT_NE(certify_sphere(torus.facets(), torus.points()).reason.find("handles"), std::string::npos);
  EXPECT_EQ(certify_sphere(torus.facets(), torus.points()).euler_characteristic, 0);
  // Two vertices of the sphere made one: its facets form two fans there.
  facets = mesh.facets();
  Points points = mesh.points();
  const int last = mesh.vertex_count() - 1;
  for (Facet& f : facets) {
    for (int& v : f) v = v == last ? 0 : v;
  }
  points.pop_back();
  EXPECT_NE(certify_sphere(facets, points).reason, "");
}

CompatibleMesh reconstructed(const SegmentedModel& source, const SegmentedModel& target) {
  return reconstruct(tests::projected_pair(source, target)).mesh;
}

TEST(Certificate, OfWholeAndHalvedModels) {
  for (const auto& cut : {tests::whole, tests::halves}) {
    const CompatibleMesh mesh = reconstructed(cut(tests::cube(6)), cut(tests::bumpy_sphere(10, 0.3)));
    const Certificate found = certify(mesh);
    EXPECT_TRUE(found.one_to_one()) << found.first_reason();
    ASSERT_EQ(found.pieces.size(), 1U);
    EXPECT_EQ(found.pieces[0].source.facets, mesh.source.facet_count());
    EXPECT_EQ(found.pieces[0].target.facets, mesh.target.facet_count());
  }
}

TEST(Certificate, IsLostWhenAVertexMovesOverItsRing) {
  CompatibleMesh mesh = reconstructed(tests::whole(tests::cube(6)), tests::whole(tests::sphere(10)));
  std::vector<SurfacePoint> images = mesh.map.images();
  std::swap(images[mesh.source.facet(20)[0]], images[mesh.source.facet(20)[1]]);
  mesh.map = SurfaceMap(mesh.source, mesh.target, images);
  const Certificate found = certify(mesh);
  EXPECT_FALSE(found.one_to_one());
  EXPECT_GT(found.pieces[0].source.folds, 0);
  EXPECT_NE(found.first_reason().find("positively"), std::string::npos);
}

TEST(Certificate, NeedsEveryPartInOneChart) {
  CompatibleMesh mesh = reconstructed(tests::halves(tests::cube(6)), tests::halves(tests::sphere(10)));
  CompatibleMesh none = mesh;
  none.charts.clear();
  EXPECT_FALSE(certify(none).one_to_one());
  CompatibleMesh twice = mesh;
  twice.charts.push_back(twice.charts.front());
  EXPECT_NE(certify(twice).first_reason().find("2 charts"), std::string::npos);
}

TEST(Certificate, OfHullMapsIsPartByPart) {
  HullMap map = tests::projected(tests::halves(tests::sphere(8)));
  EXPECT_TRUE(certify(map).one_to_one());
  ASSERT_EQ(certify(map).pieces.size(), 2U);
  std::swap(map.images[1][3], map.images[1][4]);
  EXPECT_FALSE(certify(map).one_to_one());
  EXPECT_TRUE(certify(map).pieces[0].one_to_one());
}

}  // namespace
}  // namespace partwise
