#include "solve/sparse_cholesky.h"

#include <gtest/gtest.h>

namespace partwise {
namespace {

/// Laplacian of a path of `n` nodes plus `diagonal`, lower triangle.
Eigen::SparseMatrix<double> path(int n, double diagonal) {
  Eigen::SparseMatrix<double> lower(n, n);
  for (int i = 0; i < n; ++i) {
    lower.insert(i, i) = (i > 0 ? 1 : 0) + (i + 1 < n ? 1 : 0) + diagonal;
    if (i + 1 < n) lower.insert(i + 1, i) = -1;
  }
  lower.makeCompressed();
  return lower;
}

class SparseCholeskyTest : public testing::TestWithParam<CholeskyBlocks> {};

TEST_P(SparseCholeskyTest, SolvesAlsoWithNewValuesInTheSamePattern) {
  SparseCholesky solver(GetParam());
  for (const double diagonal : {0.5, 2.0}) {
    const Eigen::SparseMatrix<double> lower = path(50, diagonal);
    ASSERT_TRUE(solver.factorize(lower));
    const Eigen::MatrixXd right = Eigen::MatrixXd::Random(50, 3);
    const Eigen::MatrixXd x = solver.solve(right);
    EXPECT_LT((lower.selfadjointView<Eigen::Lower>() * x - right).norm(), 1e-12);
  }
}

TEST_P(SparseCholeskyTest, RefusesWhatIsNotPositiveDefinite) {
  EXPECT_FALSE(SparseCholesky(GetParam()).factorize(path(50, -0.5)));
}

INSTANTIATE_TEST_SUITE_P(Blocks, SparseCholeskyTest,
                         testing::Values(CholeskyBlocks::always, CholeskyBlocks::where_quicker));

}  // namespace
}  // namespace partwise
