#include "measure/ground_truth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

#include "builders.h"
#include "error.h"
#include "measure/geodesic_search.h"

namespace partwise {
namespace {

SurfacePoint at_vertex(const TriMesh& mesh, int vertex) {
  for (int f = 0; f < mesh.facet_count(); ++f) {
    for (int i = 0; i < 3; ++i) {
      if (mesh.facet(f)[i] == vertex) return {f, Vec3::Unit(i)};
    }
  }
  return {};
}

SurfaceMap to_vertices(const TriMesh& mesh, auto&& image) {
  std::vector<SurfacePoint> images;
  for (int v = 0; v < mesh.vertex_count(); ++v) images.push_back(at_vertex(mesh, image(v)));
  return SurfaceMap(mesh, mesh, images);
}

std::string error_of(auto&& function) {
  try {
    function();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(GeodesicSearch, IsExactInAPlane) {
  const TriMesh grid = tests::grid(9);
  GeodesicSearch search(grid);
  for (const int from : {0, 17, 44, 99}) {
    for (int f = 0; f < grid.facet_count(); ++f) {
      const SurfacePoint goal{f, Vec3(0.2, 0.5, 0.3)};
      EXPECT_NEAR(search.distance(from, goal), (position(grid, goal) - grid.point(from)).norm(), 1e-12);
    }
  }
}

TEST(GeodesicSearch, IsNearTheGreatCircleOnASphere) {
  const TriMesh sphere = tests::sphere(24);
  GeodesicSearch search(sphere);
  for (int v = 1; v < sphere.vertex_count(); v += 7) {
    const double arc = std::acos(std::clamp(sphere.point(0).dot(sphere.point(v)), -1.0, 1.0));
    EXPECT_NEAR(search.distance(0, at_vertex(sphere, v)), arc, 0.015 * arc + 1e-12);
  }
}

TEST(GeodesicSearch, DoesNotJumpOverAGap) {
  // Around the torus' hole the chord is short, the way over the surface long.
  const TriMesh torus = tests::torus(3, 1, 64, 24);
  const int inner = 12, opposite = 32 * 24 + 12;
  EXPECT_NEAR((torus.point(inner) - torus.point(opposite)).norm(), 4, 1e-12);
  EXPECT_NEAR(GeodesicSearch(torus).distance(inner, at_vertex(torus, opposite)), 2 * std::numbers::pi, 0.05);
}

TEST(GeodesicSearch, HasNoPathBetweenComponents) {
  const TriMesh two({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}},
                    {{0, 1, 2}, {3, 4, 5}});
  GeodesicSearch search(two);
  EXPECT_EQ(search.distance(0, {1, Vec3::Unit(0)}), std::numeric_limits<double>::infinity());
  EXPECT_NEAR(search.distance(0, {0, Vec3::Unit(1)}), 1, 1e-15)
      << "scratch memory is cleared between searches";
}

TEST(GroundTruth, TheTrueMapHasNoError) {
  const TriMesh sphere = tests::sphere(6);
  const GroundTruthErrors errors = ground_truth_errors(to_vertices(sphere, [](int v) { return v; }),
                                                       identity_truth(sphere, sphere), sphere);
  EXPECT_EQ(errors.vertices, sphere.vertex_count());
  EXPECT_EQ(errors.max, 0);
  EXPECT_EQ(errors.share_below_05, 1);
}

TEST(GroundTruth, ErrorsAreOverTheRootOfTheArea) {
  // On the square of area 4 all vertices of a row of 11 go to its first: errors 0, 0.2, ... 2 over 2.
  const TriMesh grid = tests::grid(10);
  const GroundTruthErrors errors = ground_truth_errors(to_vertices(grid, [](int v) { return v - v % 11; }),
                                                       identity_truth(grid, grid), grid);
  EXPECT_NEAR(errors.mean, 0.5, 1e-12);
  EXPECT_NEAR(errors.median, 0.5, 1e-12);
  EXPECT_NEAR(errors.quantile_90, 0.9, 1e-12);
  EXPECT_NEAR(errors.quantile_99, 1, 1e-12);
  EXPECT_NEAR(errors.max, 1, 1e-12);
  EXPECT_NEAR(errors.share_below_05, 1.0 / 11, 1e-12);
  EXPECT_NEAR(errors.share_below_25, 3.0 / 11, 1e-12);
}

TEST(GroundTruth, AFileGivesATargetVertexPerLine) {
  const TriMesh mesh = tests::tetrahedron();
  std::istringstream in("3\n-1\n0\n2\n");
  EXPECT_EQ(read_truth(in, mesh, mesh), (GroundTruth{3, kNoTruth, 0, 2}));
}

TEST(GroundTruth, FaultsOfAFileAreNamed) {
  const TriMesh mesh = tests::tetrahedron();
  auto reading = [&](const char* text) {
    return error_of([&] {
      std::istringstream in(text);
      read_truth(in, mesh, mesh);
    });
  };
  EXPECT_NE(reading("0\nx\n2\n3\n").find("line 2"), std::string::npos);
  EXPECT_NE(reading("0\n1 2\n2\n3\n").find("line 2"), std::string::npos);
  EXPECT_NE(reading("0\n1\n4\n3\n").find("vertex 4"), std::string::npos);
  EXPECT_NE(reading("0\n1\n-2\n3\n").find("vertex -2"), std::string::npos);
  EXPECT_NE(reading("0\n1\n2\n").find("3 lines"), std::string::npos);
  EXPECT_NE(error_of([&] { identity_truth(tests::cube(2), mesh); }).find("4"), std::string::npos);
}

TEST(GroundTruth, OfNoVertexIsAnError) {
  const TriMesh mesh = tests::tetrahedron();
  const SurfaceMap map = to_vertices(mesh, [](int v) { return v; });
  EXPECT_THROW(ground_truth_errors(map, GroundTruth(4, kNoTruth), mesh), InputError);
}

}  // namespace
}  // namespace partwise
