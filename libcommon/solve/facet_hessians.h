#pragma once

#include <Eigen/Sparse>

#include <vector>

#include "mesh/types.h"

namespace partwise {

/// Numbers the vertices that may move, from 0 and ascending; fixed ones get -1.
/// \param fixed empty (none) or one per vertex
std::vector<int> numbered_unknowns(int vertex_count, const std::vector<bool>& fixed);

/// The Hessian of an energy that is a sum over facets, with two unknowns per vertex: 6 x 6 blocks of facets
/// added into a sparse matrix whose pattern and slots are found once.
class FacetHessians {
 public:
  using Block = Eigen::Matrix<double, 6, 6>;

  /// \param unknowns per vertex: its number, or -1; see numbered_unknowns
  FacetHessians(const Facets& facets, const std::vector<int>& unknowns);

  /// The sum, its lower triangle; rows and columns 2 u and 2 u + 1 belong to unknown u.
  /// \param blocks one per facet, two rows per corner
  Eigen::SparseMatrix<double>& assemble(const std::vector<Block>& blocks);

 private:
  /// Calls f(row, column, facet, local row, local column) for every entry of the lower triangle.
  template <class Function>
  void visit(Function f) const;

  Facets facets_;
  std::vector<int> unknowns_;
  Eigen::SparseMatrix<double> matrix_;
  std::vector<int> slots_;
};

}  // namespace partwise
