#include "segmentation/split_boundaries.h"

#include <gtest/gtest.h>

#include <cmath>

#include "builders.h"
#include "error.h"
#include "geometry/normals.h"
#include "mesh/curve_roughness.h"
#include "mesh/segmentation.h"

namespace partwise {
namespace {

class Capsule : public testing::Test {
 protected:
  TriMesh mesh = tests::capsule(4, 24, 48);
  Seeds seeds{std::vector<int>(mesh.vertex_count(), kUnseeded),
              std::vector<int>(mesh.facet_count(), kUnseeded)};

  Vec3 centroid(int f) const {
    const auto& [a, b, c] = mesh.facet(f);
    return (mesh.point(a) + mesh.point(b) + mesh.point(c)) / 3;
  }

  /// Two halves along a plane that no row of edges follows.
  std::vector<int> slanted() const {
    std::vector<int> labels;
    for (int f = 0; f < mesh.facet_count(); ++f)
      labels.push_back(centroid(f).dot(Vec3(0.3, 0.2, 1)) < 0.1 ? 1 : 0);
    return labels;
  }

  double area(const Points& points, const Facets& facets) const {
    double sum = 0;
    for (const double a : facet_areas(points, facets)) sum += a;
    return sum;
  }
};

TEST_F(Capsule, BoundaryBecomesSmootherOnTheSameSurface) {
  const Segmentation before = trace_boundaries(mesh, {"upper", "lower"}, slanted());
  const SplitMeshLabels split = split_along_boundaries(mesh, before.names, seeds, before.labels, 8);
  const Segmentation after = trace_boundaries(split.mesh, before.names, split.labels);
  ASSERT_EQ(after.curves.size(), 1U);
  EXPECT_GT(mean_roughness(mesh, before), 1.1);
  EXPECT_LT(mean_roughness(split.mesh, after), 1.04)
      << "half of it is the shrinking of a closed curve of 48 vertices";
  // Facets are cut, not moved.
  EXPECT_NEAR(area(split.mesh.points(), split.mesh.facets()), area(mesh.points(), mesh.facets()), 1e-9);
  for (int v = 0; v < mesh.vertex_count(); ++v) ASSERT_EQ(split.mesh.point(v), mesh.point(v));
  EXPECT_EQ(split.added_vertices, static_cast<int>(after.curves.front().vertices.size()))
      << "every added vertex is on the boundary";
  EXPECT_EQ(split.mesh.facet_count(), mesh.facet_count() + split.added_facets);
  EXPECT_EQ(split.added_facets, 2 * split.added_vertices);
}

TEST_F(Capsule, SeededVerticesKeepTheirPart) {
  const std::vector<int> labels = slanted();
  int seeded = 0;  // in the upper half, next to the boundary
  while (labels[seeded] != 0 || std::abs(centroid(seeded).dot(Vec3(0.3, 0.2, 1)) - 0.1) > 0.03) ++seeded;
  for (const int v : mesh.facet(seeded)) seeds.vertex_part[v] = 0;
  const SplitMeshLabels split = split_along_boundaries(mesh, {"upper", "lower"}, seeds, labels, 8);
  for (std::size_t f = 0; f < split.labels.size(); ++f) {
    for (const int v : split.mesh.facets()[f]) {
      const bool is_seeded = v < mesh.vertex_count() && seeds.vertex_part[v] == 0;
      EXPECT_TRUE(!is_seeded || split.labels[f] == 0) << "vertex " << v;
    }
  }
}

TEST_F(Capsule, ThreePartsMeetInsideAFacet) {
  std::vector<int> labels = slanted();
  for (int f = 0; f < mesh.facet_count(); ++f) {
    if (labels[f] == 1 && centroid(f).x() < 0.05) labels[f] = 2;
  }
  const SplitMeshLabels split = split_along_boundaries(mesh, {"a", "b", "c"}, seeds, labels, 8);
  const Segmentation parts = trace_boundaries(split.mesh, {"a", "b", "c"}, split.labels);
  EXPECT_EQ(parts.cross_points.size(), 2U);
  EXPECT_EQ(parts.curves.size(), 3U);
}

TEST_F(Capsule, APartTooThinIsNamed) {
  std::vector<int> labels(mesh.facet_count(), 0);
  labels[100] = 1;
  try {
    split_along_boundaries(mesh, {"most", "speck"}, seeds, labels, 8);
    FAIL() << "the speck has no vertex left";
  } catch (const ComputationError& error) {
    EXPECT_NE(std::string(error.what()).find("'speck'"), std::string::npos);
  }
}

}  // namespace
}  // namespace partwise
