#include "geometry/mean_value_weights.h"

#include <gtest/gtest.h>

#include <cmath>

#include "builders.h"

namespace partwise {
namespace {

TEST(MeanValueWeights, AreEqualAtTheHubOfARegularHexagon) {
  Points points{{0, 0, 0}};
  Facets facets;
  for (int i = 0; i < 6; ++i) {
    points.emplace_back(std::cos(i * M_PI / 3), std::sin(i * M_PI / 3), 0);
    facets.push_back({0, 1 + i, 1 + (i + 1) % 6});
  }
  const VertexWeights weights = mean_value_weights(points, facets);
  for (int i = 1; i <= 6; ++i) EXPECT_NEAR(weights.coeff(0, i), 1.0 / 6, 1e-15);
}

/// The property the paper relies on: in the plane the weighted neighbours reproduce the vertex.
TEST(MeanValueWeights, ReproduceInteriorVerticesOfPlanarMeshes) {
  const TriMesh flat = tests::grid(6);
  Points points = flat.points();
  for (Vec3& p : points) p += Vec3(0.05 * std::sin(9 * p.y()), 0.05 * std::cos(7 * p.x()), 0);
  const VertexWeights weights = mean_value_weights(points, flat.facets());
  for (int v = 0; v < flat.vertex_count(); ++v) {
    if (flat.half_edges().is_boundary(OpenMesh::VertexHandle(v))) continue;
    Vec3 mean = Vec3::Zero();
    for (VertexWeights::InnerIterator it(weights, v); it; ++it) mean += it.value() * points[it.col()];
    EXPECT_NEAR((mean - points[v]).norm(), 0, 1e-14) << "vertex " << v;
  }
}

TEST(MeanValueWeights, AreInvariantUnderSimilarity) {
  const TriMesh mesh = tests::bumpy_sphere(6, 0.3);
  Points moved;
  for (const Vec3& p : mesh.points()) moved.push_back(1000 * Vec3(p.y(), p.z(), p.x()) + Vec3(5, 6, 7));
  const VertexWeights before = mean_value_weights(mesh.points(), mesh.facets());
  EXPECT_LT((before - mean_value_weights(moved, mesh.facets())).norm(), 1e-9);
}

}  // namespace
}  // namespace partwise
