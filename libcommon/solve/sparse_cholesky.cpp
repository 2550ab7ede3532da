#include "solve/sparse_cholesky.h"

#include <Eigen/CholmodSupport>

namespace partwise {

struct SparseCholesky::Factor {
  Eigen::CholmodDecomposition<Eigen::SparseMatrix<double>, Eigen::Lower> cholmod;
  bool analysed = false;
};

SparseCholesky::SparseCholesky() : factor_(std::make_unique<Factor>()) {
  factor_->cholmod.setMode(Eigen::CholmodSupernodalLLt);
}
SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;

bool SparseCholesky::factorize(const Eigen::SparseMatrix<double>& lower) {
  if (!factor_->analysed) {
    factor_->cholmod.cholmod().print = 0;  // failure is reported by the return value
    factor_->cholmod.analyzePattern(lower);
    factor_->analysed = true;
  }
  factor_->cholmod.factorize(lower);
  return factor_->cholmod.info() == Eigen::Success;
}

Eigen::MatrixXd SparseCholesky::solve(const Eigen::MatrixXd& right_hand_sides) const {
  return factor_->cholmod.solve(right_hand_sides);
}

}  // namespace partwise
