#include "geometry/curvature.h"

#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

#include "builders.h"
#include "geometry/normals.h"

namespace partwise {
namespace {

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

TEST(Curvature, TotalIsTwoPiTimesTheEulerCharacteristic) {
  const double pi = std::numbers::pi;
  EXPECT_NEAR(sum(angle_defects(tests::sphere(7))), 4 * pi, 1e-11);
  EXPECT_NEAR(sum(angle_defects(tests::bumpy_sphere(12, 0.4))), 4 * pi, 1e-11);
  EXPECT_NEAR(sum(angle_defects(tests::cube(3))), 4 * pi, 1e-11);
  EXPECT_NEAR(sum(angle_defects(tests::torus(2, 0.5, 20, 11))), 0, 1e-11);
  EXPECT_NEAR(sum(angle_defects(tests::grid(4))), 2 * pi, 1e-11);  // a disc, with the boundary's turning
  EXPECT_NEAR(sum(angle_defects(tests::hemisphere(8))), 2 * pi, 1e-11);
}

TEST(Curvature, MixedAreasSumToTheArea) {
  for (const TriMesh& mesh : {tests::bumpy_sphere(9, 0.5), tests::grid(3), tests::torus(3, 1, 50, 4)}) {
    EXPECT_NEAR(sum(mixed_areas(mesh)), sum(facet_areas(mesh.points(), mesh.facets())), 1e-12);
  }
}

TEST(Curvature, OfAUnitSphereIsOne) {
  for (const double k : gaussian_curvature(tests::sphere(40))) EXPECT_NEAR(k, 1, 0.02);
}

TEST(Curvature, OfAPlaneIsZeroInside) {
  const TriMesh flat = tests::grid(5);
  const std::vector<double> curvature = gaussian_curvature(flat);
  for (int v = 0; v < flat.vertex_count(); ++v) {
    if (!flat.half_edges().is_boundary(OpenMesh::VertexHandle(v))) {
      EXPECT_NEAR(curvature[v], 0, 1e-11);
    }
  }
}

TEST(Curvature, OfACubeSitsInItsCorners) {
  const TriMesh box = tests::cube(4);
  const std::vector<double> defects = angle_defects(box), areas = mixed_areas(box);
  const std::vector<double> curvature = gaussian_curvature(box);
  int corners = 0;
  for (int v = 0; v < box.vertex_count(); ++v) {
    if (box.point(v).cwiseAbs().minCoeff() < 1) {
      EXPECT_NEAR(defects[v], 0, 1e-12);
      continue;
    }
    ++corners;
    EXPECT_NEAR(defects[v], std::numbers::pi / 2, 1e-12);
    EXPECT_NEAR(areas[v], 3 * 0.25 * 0.25, 1e-12);  // a quarter of each of three squares with sides 1/2
    EXPECT_NEAR(curvature[v], defects[v] / areas[v], 1e-9);
  }
  EXPECT_EQ(corners, 8);
}

TEST(Curvature, ScalesWithTheInverseArea) {
  const TriMesh mesh = tests::bumpy_sphere(6, 0.3);
  Points larger = mesh.points();
  for (Vec3& p : larger) p *= 10;
  const std::vector<double> before = gaussian_curvature(mesh);
  const std::vector<double> after = gaussian_curvature(mesh.with_points(larger));
  for (int v = 0; v < mesh.vertex_count(); ++v) EXPECT_NEAR(after[v] * 100, before[v], 1e-10);
}

}  // namespace
}  // namespace partwise
