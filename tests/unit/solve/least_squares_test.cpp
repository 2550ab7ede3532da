#include "solve/least_squares.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "builders.h"
#include "energy/laplacian.h"
#include "error.h"

namespace partwise {
namespace {

struct WeightedTerm {
  double weight;
  EnergyTerm term;
};

/// The same minimum by dense normal equations.
Eigen::MatrixXd dense_minimum(int n, const std::vector<WeightedTerm>& sum) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n), right = Eigen::MatrixXd::Zero(n, 3);
  for (const auto& [weight, term] : sum) {
    const Eigen::MatrixXd rows = term.rows;
    matrix += weight * rows.transpose() * term.weights.asDiagonal() * rows;
    right += weight * rows.transpose() * term.weights.asDiagonal() * Eigen::MatrixXd(term.targets);
  }
  return matrix.ldlt().solve(right);
}

Points minimum(LeastSquares& system, const std::vector<WeightedTerm>& sum) {
  system.clear();
  for (const auto& [weight, term] : sum) system.add(weight, term);
  return system.minimise();
}

void expect_equal(const Points& points, const Eigen::MatrixXd& expected) {
  for (std::size_t v = 0; v < points.size(); ++v)
    EXPECT_LT((points[v] - expected.row(v).transpose()).norm(), 1e-9) << "vertex " << v;
}

TEST(LeastSquares, AgreesWithDenseAlgebraAlsoAfterChanges) {
  const TriMesh mesh = tests::bumpy_sphere(3, 0.5);
  const int n = mesh.vertex_count();
  const EnergyTerm smooth = laplacian_term(mean_value_weights(mesh.points(), mesh.facets()));
  const EnergyTerm few = point_term(n, {{0, {1, 2, 3}, 1}, {7, {0, 1, 0}, 2}, {20, {-1, 0, 1}, 0.1}});
  const EnergyTerm other = point_term(n, {{3, {1, 1, 1}, 1}, {9, {0, 0, 4}, 1}});
  LeastSquares system(n);
  for (const std::vector<WeightedTerm>& sum :
       {std::vector<WeightedTerm>{{1, smooth}, {0.3, few}},
        {{1, smooth}, {0.3, few}, {0.01, other}},
        {{2, smooth}, {10, other}},
        {{1, few}, {1, smooth}, {1, point_term(n, {{3, {0, 0, 0}, 1}})}}}) {
    expect_equal(minimum(system, sum), dense_minimum(n, sum));
  }
}

TEST(LeastSquares, FixedVerticesStayExactlyAndActOnTheOthers) {
  const TriMesh mesh = tests::grid(4);
  const int n = mesh.vertex_count();
  std::vector<VertexTarget> border;
  for (int v = 0; v < n; ++v) {
    if (mesh.half_edges().is_boundary(OpenMesh::VertexHandle(v)))
      border.push_back({v, 3 * mesh.point(v) + Vec3(0.1, 0.7, 0.3)});
  }
  LeastSquares system(n, border);
  // With mean-value weights, linear functions are reproduced inside. Rows of fixed vertices would disturb.
  EnergyTerm inner = laplacian_term(mean_value_weights(mesh.points(), mesh.facets()));
  for (const VertexTarget& b : border) inner.weights[b.vertex] = 0;
  system.add(1, inner);
  const Points points = system.minimise();
  for (int v = 0; v < n; ++v) EXPECT_LT((points[v] - 3 * mesh.point(v) - Vec3(0.1, 0.7, 0.3)).norm(), 1e-12);
  for (const VertexTarget& b : border) EXPECT_EQ(points[b.vertex], b.target);
}

TEST(LeastSquares, MinimumHasNoSlope) {
  const TriMesh mesh = tests::torus(2, 0.7, 12, 6);
  const int n = mesh.vertex_count();
  const EnergyTerm smooth = laplacian_term(uniform_weights(n, mesh.facets()));
  const EnergyTerm pulls = point_term(n, {{0, {4, 0, 0}, 1}, {30, {0, 4, 0}, 1}, {50, {0, 0, 2}, 1}});
  LeastSquares system(n);
  const Points points = minimum(system, {{1, smooth}, {0.3, pulls}});
  const auto value = [&](const Points& at) { return energy(smooth, at) + 0.3 * energy(pulls, at); };
  for (const int v : {0, 11, 30, 47}) {
    for (int axis = 0; axis < 3; ++axis) {
      Points ahead = points, behind = points;
      ahead[v][axis] += 1e-4;
      behind[v][axis] -= 1e-4;
      EXPECT_NEAR((value(ahead) - value(behind)) / 2e-4, 0, 1e-9);
    }
  }
}

TEST(LeastSquares, SaysWhenPositionsAreNotDetermined) {
  LeastSquares system(3);
  system.add(1, point_term(3, {{0, {1, 0, 0}, 1}, {1, {1, 0, 0}, 1}}));
  EXPECT_THROW(system.minimise(), ComputationError);
}

}  // namespace
}  // namespace partwise
