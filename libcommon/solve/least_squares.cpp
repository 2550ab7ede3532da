#include "solve/least_squares.h"

#include <algorithm>

#include "error.h"
#include "solve/sparse_cholesky.h"

namespace partwise {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

bool same_pattern(const Matrix& a, const Matrix& b) {
  return a.rows() == b.rows() && a.nonZeros() == b.nonZeros() &&
         std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.outerSize() + 1, b.outerIndexPtr()) &&
         std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

}  // namespace

/// Normal equations over the free vertices: matrix * V = right_hand_sides.
struct LeastSquares::System {
  std::vector<int> unknown;  // per vertex, -1 when fixed
  Points positions;          // of the fixed vertices
  int unknown_count = 0;
  Matrix matrix;
  Eigen::MatrixX3d right_hand_sides;
  Matrix analysed;
  SparseCholesky factor;

  /// Splits the term's rows into free columns; fixed columns move to the right-hand side.
  void add(double weight, const EnergyTerm& term) {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(term.rows.nonZeros());
    Eigen::MatrixX3d targets = term.targets;
    for (Eigen::Index r = 0; r < term.rows.rows(); ++r) {
      for (decltype(term.rows)::InnerIterator entry(term.rows, r); entry; ++entry) {
        const int vertex = static_cast<int>(entry.col());
        if (unknown[vertex] >= 0) {
          entries.emplace_back(r, unknown[vertex], entry.value());
        } else {
          targets.row(r) -= entry.value() * positions[vertex].transpose();
        }
      }
    }
    Matrix rows(term.rows.rows(), unknown_count);
    rows.setFromTriplets(entries.begin(), entries.end());
    Matrix weighted = rows;  // scaled in place: Eigen's product with a diagonal grows entry by entry
    for (Eigen::Index column = 0; column < weighted.cols(); ++column) {
      for (Matrix::InnerIterator entry(weighted, column); entry; ++entry) {
        entry.valueRef() *= weight * term.weights[entry.row()];
      }
    }
    const Matrix transposed = rows.transpose();
    matrix += Matrix(transposed * weighted);
    right_hand_sides += weighted.transpose() * targets;
  }
};

LeastSquares::LeastSquares(int vertex_count, const std::vector<VertexTarget>& fixed)
    : system_(std::make_unique<System>()) {
  system_->unknown.assign(vertex_count, 0);
  system_->positions.assign(vertex_count, Vec3::Zero());
  for (const VertexTarget& f : fixed) {
    system_->unknown[f.vertex] = -1;
    system_->positions[f.vertex] = f.target;
  }
  for (int& unknown : system_->unknown) {
    if (unknown == 0) unknown = system_->unknown_count++;
  }
  clear();
}

LeastSquares::~LeastSquares() = default;
LeastSquares::LeastSquares(LeastSquares&&) noexcept = default;
LeastSquares& LeastSquares::operator=(LeastSquares&&) noexcept = default;

void LeastSquares::clear() {
  const int n = system_->unknown_count;
  system_->matrix = Matrix(n, n);
  system_->right_hand_sides = Eigen::MatrixX3d::Zero(n, 3);
}

void LeastSquares::add(double weight, const EnergyTerm& term) {
  system_->add(weight, term);
}

Points LeastSquares::minimise() {
  System& system = *system_;
  Points points = system.positions;
  if (system.unknown_count == 0) return points;
  const Matrix lower = system.matrix.triangularView<Eigen::Lower>();
  if (!same_pattern(lower, system.analysed)) {
    system.factor = SparseCholesky();
    system.analysed = lower;
  }
  if (!system.factor.factorize(lower)) {
    throw ComputationError(
        "the positions of some vertices are not determined: a component has neither a constraint nor a fixed "
        "vertex");
  }
  const Eigen::MatrixXd solution = system.factor.solve(system.right_hand_sides);
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (system.unknown[v] >= 0) points[v] = solution.row(system.unknown[v]).transpose();
  }
  return points;
}

}  // namespace partwise
