#include "measure/hull_folds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "builders.h"

namespace partwise {
namespace {

TEST(HullFolds, ACubeSeenFromInsideIsCoveredOnce) {
  const TriMesh mesh = tests::cube(4);
  for (const Vec3& centre : {Vec3(0, 0, 0), Vec3(0.9, -0.8, 0.7)}) {
    const HullFolds found = hull_folds(mesh.points(), mesh.facets(), centre);
    EXPECT_EQ(found.count(), 0);
    EXPECT_NEAR(found.degree, 1, 1e-12);
    EXPECT_TRUE(found.one_to_one());
  }
}

TEST(HullFolds, ATurnedOverSurfaceIsAllFoldedWithDegreeMinusOne) {
  const TriMesh mesh = tests::cube(2);
  Points mirrored = mesh.points();
  for (Vec3& p : mirrored) p.x() = -p.x();
  const HullFolds found = hull_folds(mirrored, mesh.facets(), Vec3::Zero());
  EXPECT_EQ(found.count(), mesh.facet_count());
  EXPECT_NEAR(found.degree, -1, 1e-12);
}

TEST(HullFolds, NamesTheFacetsThatOneMisplacedVertexFolds) {
  const TriMesh mesh = tests::sphere(4);
  Points points = mesh.points();
  const Facet& first = mesh.facet(0);
  // Vertex 0 of facet 0 moves across the opposite edge.
  points[first[0]] = (points[first[1]] + points[first[2]] - 0.8 * points[first[0]]).normalized();
  const HullFolds found = hull_folds(points, mesh.facets(), Vec3::Zero());
  ASSERT_GT(found.count(), 0);
  EXPECT_EQ(found.folded.front(), 0);
  EXPECT_NEAR(found.degree, 1, 1e-12);
  EXPECT_FALSE(found.one_to_one());
}

TEST(HullFolds, WithoutFoldsASphereMayStillBeCoveredTwice) {
  // A double cover of the sphere around the z axis, branched at the poles: only degree gives it away.
  const int around = 16, along = 6;
  Points points{{0, 0, -1}};
  for (int i = 1; i < along; ++i) {
    for (int j = 0; j < around; ++j) {
      const double latitude = std::numbers::pi * i / along - std::numbers::pi / 2,
                   longitude = 2 * 2 * std::numbers::pi * j / around;
      points.emplace_back(std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                          std::sin(latitude));
    }
  }
  points.emplace_back(0, 0, 1);
  const TriMesh sphere = tests::capsule(0, around, along);
  ASSERT_EQ(sphere.vertex_count(), static_cast<int>(points.size()));
  const HullFolds found = hull_folds(points, sphere.facets(), Vec3::Zero());
  EXPECT_EQ(found.count(), 0);
  EXPECT_NEAR(found.degree, 2, 1e-12);
  EXPECT_FALSE(found.one_to_one());
}

TEST(HullFolds, AFacetWithoutAreaIsAFold) {
  const TriMesh mesh = tests::tetrahedron();
  Points points = mesh.points();
  points[0] = points[1];
  EXPECT_GE(hull_folds(points, mesh.facets(), Vec3::Zero()).count(), 2);
}

}  // namespace
}  // namespace partwise
