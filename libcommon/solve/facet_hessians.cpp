#include "solve/facet_hessians.h"

#include <algorithm>

namespace partwise {

std::vector<int> numbered_unknowns(int vertex_count, const std::vector<bool>& fixed) {
  std::vector<int> unknowns(vertex_count, -1);
  int next = 0;
  for (int v = 0; v < vertex_count; ++v) {
    if (fixed.empty() || !fixed[v]) unknowns[v] = next++;
  }
  return unknowns;
}

template <class Function>
void FacetHessians::visit(Function f) const {
  for (std::size_t t = 0; t < facets_.size(); ++t) {
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) {
        const int u = unknowns_[facets_[t][i / 2]], v = unknowns_[facets_[t][j / 2]];
        if (u < 0 || v < 0) continue;
        const int row = 2 * u + i % 2, column = 2 * v + j % 2;
        if (row >= column) f(row, column, t, i, j);
      }
    }
  }
}

FacetHessians::FacetHessians(const Facets& facets, const std::vector<int>& unknowns)
    : facets_(facets), unknowns_(unknowns) {
  const int count = unknowns.empty() ? 0 : 1 + *std::max_element(unknowns.begin(), unknowns.end());
  matrix_.resize(2 * count, 2 * count);
  std::vector<Eigen::Triplet<double>> triplets;
  visit([&](int row, int column, std::size_t, int, int) { triplets.emplace_back(row, column, 1); });
  matrix_.setFromTriplets(triplets.begin(), triplets.end());
  visit([&](int row, int column, std::size_t, int, int) {
    const int* begin = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column];
    const int* end = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column + 1];
    slots_.push_back(static_cast<int>(std::lower_bound(begin, end, row) - matrix_.innerIndexPtr()));
  });
}

Eigen::SparseMatrix<double>& FacetHessians::assemble(const std::vector<Block>& blocks) {
  std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 0.0);
  std::size_t next = 0;
  visit([&](int, int, std::size_t facet, int i, int j) {
    matrix_.valuePtr()[slots_[next++]] += blocks[facet](i, j);
  });
  return matrix_;
}

}  // namespace partwise
