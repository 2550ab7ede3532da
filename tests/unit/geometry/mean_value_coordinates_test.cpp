#include "geometry/mean_value_coordinates.h"

#include <gtest/gtest.h>

#include "builders.h"

namespace partwise {
namespace {

Vec3 combined(const std::vector<double>& coordinates, const Points& points) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) sum += coordinates[i] * points[i];
  return sum;
}

TEST(MeanValueCoordinates, ReproduceThePoint) {
  for (const TriMesh& mesh :
       {tests::cube(3), tests::sphere(4), tests::tetrahedron(), tests::torus(2, 0.5, 12, 8)}) {
    for (const Vec3& query : {Vec3(0.1, 0.2, -0.15), Vec3(0, 0, 0.01), Vec3(-0.11, 0.03, 0.2)}) {
      const std::vector<double> coordinates = mean_value_coordinates(query, mesh.points(), mesh.facets());
      double sum = 0;
      for (const double c : coordinates) sum += c;
      EXPECT_NEAR(sum, 1, 1e-12);
      EXPECT_NEAR((combined(coordinates, mesh.points()) - query).norm(), 0, 1e-10);
    }
  }
}

TEST(MeanValueCoordinates, ArePositiveInsideAConvexSurface) {
  const TriMesh box = tests::cube(2);
  for (const double c : mean_value_coordinates({0.4, -0.7, 0.9}, box.points(), box.facets())) EXPECT_GT(c, 0);
}

TEST(MeanValueCoordinates, AreEqualAtTheCentreOfARegularTetrahedron) {
  const TriMesh solid = tests::tetrahedron();
  for (const double c : mean_value_coordinates(Vec3::Zero(), solid.points(), solid.facets())) {
    EXPECT_NEAR(c, 0.25, 1e-14);
  }
}

TEST(MeanValueCoordinates, AreBarycentricOnTheSurface) {
  const TriMesh solid = tests::tetrahedron();
  const Facet& f = solid.facet(2);
  const Vec3 query = 0.2 * solid.point(f[0]) + 0.5 * solid.point(f[1]) + 0.3 * solid.point(f[2]);
  const std::vector<double> coordinates = mean_value_coordinates(query, solid.points(), solid.facets());
  EXPECT_NEAR(coordinates[f[0]], 0.2, 1e-12);
  EXPECT_NEAR(coordinates[f[1]], 0.5, 1e-12);
  EXPECT_NEAR(coordinates[f[2]], 0.3, 1e-12);
}

}  // namespace
}  // namespace partwise
