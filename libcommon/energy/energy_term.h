#pragma once

#include <Eigen/Sparse>

#include <vector>

#include "mesh/types.h"

namespace partwise {

/// A quadratic energy of vertex positions V (n x 3): the sum over rows r of weights[r] |rows_r V -
/// targets_r|^2.
///
/// Row-major, because terms are built and read row by row.
struct EnergyTerm {
  Eigen::SparseMatrix<double, Eigen::RowMajor> rows;  ///< r x n
  Eigen::MatrixX3d targets;                           ///< r x 3
  Eigen::VectorXd weights;                            ///< r, >= 0
};

/// A vertex and where it should be.
struct VertexTarget {
  int vertex = 0;
  Vec3 target = Vec3::Zero();
  double weight = 1;
};

/// Sum over `pulls` of weight |v_i - target_i|^2. \pre 0 <= vertex < vertex_count
EnergyTerm point_term(int vertex_count, const std::vector<VertexTarget>& pulls);

/// Value of the term at `points`. \pre points.size() is the number of columns of the term's rows
double energy(const EnergyTerm& term, const Points& points);

}  // namespace partwise
