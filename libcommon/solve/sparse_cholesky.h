#pragma once

#include <Eigen/Sparse>

#include <memory>

namespace partwise {

/// How a factorisation proceeds: by dense blocks, or as CHOLMOD judges by the number of operations per entry;
/// column by column is twice as quick where there are few, as for the Laplacian of a small surface.
enum class CholeskyBlocks { always, where_quicker };

/// Cholesky factorisations of symmetric positive definite matrices that share one pattern of non-zeros.
class SparseCholesky {
 public:
  explicit SparseCholesky(CholeskyBlocks blocks = CholeskyBlocks::always);
  ~SparseCholesky();
  SparseCholesky(SparseCholesky&&) noexcept;
  SparseCholesky& operator=(SparseCholesky&&) noexcept;

  /// Factorises `lower`, of which only the lower triangle is read; the first call also analyses the pattern,
  /// which later matrices must share. \return false when the matrix is not positive definite.
  bool factorize(const Eigen::SparseMatrix<double>& lower);

  /// Solves for one or several right-hand sides (columns). \pre the last factorize succeeded
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right_hand_sides) const;

 private:
  struct Factor;
  std::unique_ptr<Factor> factor_;
};

}  // namespace partwise
