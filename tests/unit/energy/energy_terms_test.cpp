#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "builders.h"
#include "energy/boundary_correspondence.h"
#include "energy/convex_approximation.h"
#include "energy/critical_constraint.h"
#include "energy/global_constraint.h"
#include "energy/laplacian.h"
#include "geometry/normals.h"

namespace partwise {
namespace {

TEST(LaplacianTerm, IsTheDistanceToTheMeanOfTheNeighbours) {
  // In a tetrahedron every neighbour counts the same by either weights: v_i - mean of others = 4/3 v_i.
  const TriMesh mesh = tests::tetrahedron();
  const EnergyTerm uniform = laplacian_term(uniform_weights(4, mesh.facets()));
  const EnergyTerm mean_value = laplacian_term(mean_value_weights(mesh.points(), mesh.facets()));
  EXPECT_NEAR(energy(uniform, mesh.points()), 4 * 16.0 / 9, 1e-13);
  EXPECT_NEAR(energy(mean_value, mesh.points()), 4 * 16.0 / 9, 1e-13);
}

TEST(LaplacianTerm, VanishesInsideAFlatGridWithMeanValueWeights) {
  const TriMesh mesh = tests::grid(6);
  Points bent = mesh.points();
  for (Vec3& p : bent) p.x() += 0.2 * p.y() * p.y();  // irregular but flat
  const EnergyTerm term = laplacian_term(mean_value_weights(bent, mesh.facets()));
  double inside = 0, uniform_inside = 0;
  const EnergyTerm uniform = laplacian_term(uniform_weights(bent.size(), mesh.facets()));
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.half_edges().is_boundary(OpenMesh::VertexHandle(v))) continue;
    const auto residual = [&](const EnergyTerm& t) {
      Vec3 sum = Vec3::Zero();
      for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator e(t.rows, v); e; ++e)
        sum += e.value() * bent[e.col()];
      return sum.norm();
    };
    inside = std::max(inside, residual(term));
    uniform_inside = std::max(uniform_inside, residual(uniform));
  }
  EXPECT_LT(inside, 1e-14);
  EXPECT_GT(uniform_inside, 1e-3);
}

TEST(LaplacianTerm, DetailIsKeptWithoutEnergy) {
  const TriMesh mesh = tests::bumpy_sphere(4, 0.3);
  const VertexWeights weights = mean_value_weights(mesh.points(), mesh.facets());
  EXPECT_NEAR(energy(laplacian_detail_term(weights, mesh.points()), mesh.points()), 0, 1e-28);
  EXPECT_GT(energy(laplacian_term(weights), mesh.points()), 1e-3);
}

TEST(PointTerms, AreWeightedSquaredDistances) {
  const Points points{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}};
  const std::vector<VertexTarget> pulls{{0, {0, 0, 3}, 1}, {2, {0, 0, 0}, 0.5}};
  const double by_hand = 9 + 0.5 * 4;
  EXPECT_DOUBLE_EQ(energy(global_constraint_term(3, pulls), points), by_hand);
  EXPECT_DOUBLE_EQ(energy(boundary_correspondence_term(3, pulls), points), by_hand);
  EXPECT_DOUBLE_EQ(energy(critical_constraint_term(3, pulls), points), by_hand);
}

/// A small sphere in the box [-1, 1]^3, and what its vertices see of the box along their normals.
struct InABox {
  TriMesh box = tests::cube(2);
  TriMesh ball;
  SurfaceIndex index{box};
  Points box_normals = facet_normals(box.points(), box.facets());
  std::vector<int> all;

  explicit InABox(double radius) : ball(tests::sphere(3)) {
    Points points = ball.points();
    for (Vec3& p : points) p *= radius;
    ball = ball.with_points(points);
    all.resize(ball.vertex_count());
    std::iota(all.begin(), all.end(), 0);
  }
};

TEST(ConvexApproximation, FindsTheHullAlongTheNormals) {
  const InABox scene(0.5);
  Points unit;
  for (const Vec3& p : scene.ball.points()) unit.push_back(p.normalized());
  const auto found = approach_hull(scene.all, scene.ball.points(), unit, scene.index, scene.box_normals);
  ASSERT_EQ(found.size(), scene.all.size());
  for (const HullApproach& approach : found) {
    EXPECT_NEAR(approach.target.cwiseAbs().maxCoeff(), 1, 1e-14);
    EXPECT_NEAR(approach.target.normalized().dot(unit[approach.vertex]), 1, 1e-14);
    EXPECT_NEAR(approach.distance, (approach.target - scene.ball.point(approach.vertex)).norm(), 1e-14);
  }
}

TEST(ConvexApproximation, ReversesOutsideAndDropsWhatHasNoNormal) {
  const InABox scene(0.5);
  const Points points{{0.1, 0.2, 3}, {0.1, 0.2, 3}, {0, 0, 0}, {5, 5, 5}};
  const Points normals{{0, 0, 1}, {0, 0, -1}, {0, 0, 0}, {1, 0, 0}};
  const auto found = approach_hull({0, 1, 2, 3}, points, normals, scene.index, scene.box_normals);
  // The second looks at the box's top against its normal; the third has none; the fourth misses both ways.
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].vertex, 0);
  EXPECT_DOUBLE_EQ(found[0].distance, 2);
}

TEST(ConvexApproximation, WeighsByHandAndNotByScale) {
  const std::vector<double> areas{1, 2, 3};
  const std::vector<HullApproach> approaches{{0, {1, 0, 0}, 0.0}, {2, {0, 0, 0}, 0.4}};
  const EnergyTerm term = convex_approximation_term(approaches, areas, 2);
  EXPECT_DOUBLE_EQ(term.weights[0], 1 / 0.01 * 1 / 2);
  EXPECT_DOUBLE_EQ(term.weights[1], 1 / (0.2 + 0.01) * 3 / 2);
  const EnergyTerm larger =
      convex_approximation_term({{0, {10, 0, 0}, 0.0}, {2, {0, 0, 0}, 4.0}}, {100, 200, 300}, 20);
  EXPECT_DOUBLE_EQ(larger.weights[0], term.weights[0]);
  EXPECT_DOUBLE_EQ(larger.weights[1], term.weights[1]);
}

TEST(PointTerm, OfNoPointsIsEmpty) {
  const EnergyTerm term = point_term(5, {});
  EXPECT_EQ(term.rows.rows(), 0);
  EXPECT_EQ(term.rows.cols(), 5);
  EXPECT_EQ(energy(term, Points(5, Vec3::Ones())), 0);
}

}  // namespace
}  // namespace partwise
