#include "geometry/convex_hull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "builders.h"
#include "error.h"
#include "geometry/hull_candidates.h"
#include "geometry/orientation.h"
#include "mesh/tri_mesh.h"

namespace partwise {
namespace {

double volume(const ConvexHull& hull) {
  double six_volumes = 0;
  for (const auto& [a, b, c] : hull.facets)
    six_volumes += hull.points[a].dot(hull.points[b].cross(hull.points[c]));
  return six_volumes / 6;
}

void expect_encloses(const ConvexHull& hull, const Points& points) {
  for (const auto& [a, b, c] : hull.facets) {
    for (const Vec3& p : points)
      ASSERT_LE(orientation_sign(hull.points[a], hull.points[b], hull.points[c], p), 0);
  }
}

using Corner = std::array<double, 3>;

std::set<std::array<Corner, 3>> shape(const ConvexHull& hull) {
  std::set<std::array<Corner, 3>> facets;
  for (const Facet& f : hull.facets) {
    std::array<Corner, 3> corners;
    for (int i = 0; i < 3; ++i)
      corners[i] = {hull.points[f[i]].x(), hull.points[f[i]].y(), hull.points[f[i]].z()};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    facets.insert(corners);
  }
  return facets;
}

TEST(HullCandidates, KeepEveryVertexOfTheHullAndFewOfTheInside) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Points points;
  while (points.size() < 20'000) {
    const Vec3 p(uniform(random), uniform(random), uniform(random));
    if (p.norm() <= 1) points.push_back(1e3 * Vec3::Ones() + p);
  }
  const std::vector<int> candidates = hull_candidates(points);
  EXPECT_LT(candidates.size(), points.size() / 2);
  ASSERT_TRUE(std::is_sorted(candidates.begin(), candidates.end()));
  expect_encloses(convex_hull(points), points);
}

TEST(HullCandidates, AreAllPointsOfAFlatSetAndOfACubesSides) {
  Points flat;
  for (int i = 0; i < 900; ++i) flat.emplace_back(i % 30, i / 30, 0);
  EXPECT_EQ(hull_candidates(flat).size(), flat.size());
  const TriMesh cube = tests::cube(10);
  EXPECT_EQ(hull_candidates(cube.points()).size(), cube.points().size());
}

TEST(ConvexHull, OfASubdividedCubeIsTheCube) {
  const TriMesh mesh = tests::cube(5);
  const ConvexHull hull = convex_hull(mesh.points());
  EXPECT_EQ(hull.points.size(), 8U);
  EXPECT_EQ(hull.facets.size(), 12U);
  EXPECT_EQ(volume(hull), 8);
  EXPECT_LT(hull_centre(hull).norm(), 1e-15);
  for (std::size_t i = 0; i < hull.points.size(); ++i) {
    EXPECT_EQ(hull.points[i], mesh.point(hull.part_vertex[i]));
    EXPECT_EQ(hull.points[i].cwiseAbs(), Vec3::Ones());
  }
}

TEST(ConvexHull, IsAClosedOutwardMeshAroundAllPoints) {
  for (const TriMesh& mesh :
       {tests::bumpy_sphere(12, 0.4), tests::torus(3, 1, 24, 12), tests::capsule(2, 16, 20)}) {
    const ConvexHull hull = convex_hull(mesh.points());
    EXPECT_NO_THROW(TriMesh(hull.points, hull.facets));
    EXPECT_EQ(hull.facets.size(), 2 * hull.points.size() - 4);
    EXPECT_GT(volume(hull), 0);
    expect_encloses(hull, mesh.points());
  }
}

TEST(ConvexHull, DoesNotDependOnTheOrderOfThePoints) {
  for (const TriMesh& mesh : {tests::cube(4), tests::bumpy_sphere(8, 0.4)}) {
    Points shuffled = mesh.points();
    shuffled.insert(shuffled.end(), mesh.points().begin(), mesh.points().begin() + 20);
    std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(7));
    const ConvexHull hull = convex_hull(shuffled);
    EXPECT_EQ(shape(hull), shape(convex_hull(mesh.points())));
    EXPECT_TRUE(std::is_sorted(hull.part_vertex.begin(), hull.part_vertex.end()));
  }
}

TEST(ConvexHull, RefusesFlatAndTooFewPoints) {
  const auto message = [](const Points& points) {
    try {
      convex_hull(points);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(message(tests::grid(4).points()).find("one plane"), std::string::npos);
  EXPECT_NE(message({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}).find("one plane"), std::string::npos);
  EXPECT_NE(message({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}}).find("3 distinct"), std::string::npos);
}

TEST(ConvexHull, DistancesAreThoseToTheSurface) {
  const ConvexHull hull = convex_hull(tests::cube(1).points());
  const std::vector<double> distances =
      distances_to_hull(hull, {{0, 0, 0}, {0.25, 0, 0}, {1, 0.3, 0.2}, {3, 0, 0}});
  EXPECT_DOUBLE_EQ(distances[0], 1);
  EXPECT_DOUBLE_EQ(distances[1], 0.75);
  EXPECT_NEAR(distances[2], 0, 1e-15);
  EXPECT_DOUBLE_EQ(distances[3], 2);
}

TEST(ConvexHull, CentreIsThatOfTheVolumeNotOfTheVertices) {
  // A cube with a finely sampled side, which holds most of the vertices.
  Points points = tests::sphere(10).points();
  for (Vec3& p : points) p = p.z() > 0 ? Vec3(p.x(), p.y(), 3 + p.z()) : Vec3(p.x(), p.y(), 0);
  const Vec3 centre = hull_centre(convex_hull(points));
  // Cylinder of height 3 under a half-ball: z = (3 * 1.5 + 2/3 * (3 + 3/8)) / (3 + 2/3), up to the sampling.
  EXPECT_NEAR(centre.z(), (4.5 + 2.25) / (3 + 2.0 / 3), 0.02);
  EXPECT_NEAR(centre.x(), 0, 1e-12);
}

}  // namespace
}  // namespace partwise
