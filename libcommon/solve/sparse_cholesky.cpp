#include "solve/sparse_cholesky.h"

#include <Eigen/CholmodSupport>
#include <dlfcn.h>

#include <mutex>

namespace partwise {
namespace {

/// One thread per factorisation: parts are solved side by side, and sums then have one order on every
/// machine. Looked up at run time, since any BLAS may stand behind CHOLMOD; one without this function has no
/// threads.
void use_one_blas_thread() {
  using SetThreads = void (*)(int);
  if (void* function = dlsym(RTLD_DEFAULT, "openblas_set_num_threads")) {
    reinterpret_cast<SetThreads>(function)(1);
  }
}

/// The same for CHOLMOD's own loops: to be called before each use, for OpenMP keeps the setting per thread.
/// These loops ask for a number of threads themselves, so only forbidding parallel regions holds them back.
void use_one_openmp_thread() {
  using SetLevels = void (*)(int);
  static const auto set_levels =
      reinterpret_cast<SetLevels>(dlsym(RTLD_DEFAULT, "omp_set_max_active_levels"));
  if (set_levels != nullptr) set_levels(0);
}

/// METIS, which CHOLMOD tries on large matrices, draws from the C library's one random sequence: started anew
/// for each matrix, but mixed up when two threads draw at a time. Guards that sequence.
std::mutex& ordering_mutex() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

struct SparseCholesky::Factor {
  Eigen::CholmodDecomposition<Eigen::SparseMatrix<double>, Eigen::Lower> cholmod;
  bool analysed = false;
};

SparseCholesky::SparseCholesky(CholeskyBlocks blocks) : factor_(std::make_unique<Factor>()) {
  static const bool once = (use_one_blas_thread(), true);
  static_cast<void>(once);
  if (blocks == CholeskyBlocks::always) {
    factor_->cholmod.setMode(Eigen::CholmodSupernodalLLt);
  } else {
    factor_->cholmod.setMode(Eigen::CholmodAuto);
    factor_->cholmod.cholmod().final_ll = 1;  // L L^T either way, which fails where L D L^T need not
  }
}
SparseCholesky::~SparseCholesky() = default;
SparseCholesky::SparseCholesky(SparseCholesky&&) noexcept = default;
SparseCholesky& SparseCholesky::operator=(SparseCholesky&&) noexcept = default;

bool SparseCholesky::factorize(const Eigen::SparseMatrix<double>& lower) {
  use_one_openmp_thread();
  if (!factor_->analysed) {
    factor_->cholmod.cholmod().print = 0;  // failure is reported by the return value
    const std::lock_guard<std::mutex> lock(ordering_mutex());
    factor_->cholmod.analyzePattern(lower);
    factor_->analysed = true;
  }
  factor_->cholmod.factorize(lower);
  return factor_->cholmod.info() == Eigen::Success;
}

Eigen::MatrixXd SparseCholesky::solve(const Eigen::MatrixXd& right_hand_sides) const {
  use_one_openmp_thread();
  return factor_->cholmod.solve(right_hand_sides);
}

}  // namespace partwise
