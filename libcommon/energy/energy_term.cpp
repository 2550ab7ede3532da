#include "energy/energy_term.h"

namespace partwise {

EnergyTerm point_term(int vertex_count, const std::vector<VertexTarget>& pulls) {
  const auto count = static_cast<Eigen::Index>(pulls.size());
  EnergyTerm term{Eigen::SparseMatrix<double, Eigen::RowMajor>(count, vertex_count),
                  Eigen::MatrixX3d(count, 3), Eigen::VectorXd(count)};
  if (count == 0) return term;  // Eigen's makeCompressed writes past the end of a matrix without rows
  term.rows.reserve(Eigen::VectorXi::Constant(count, 1));
  for (Eigen::Index r = 0; r < count; ++r) {
    const VertexTarget& pull = pulls[r];
    term.rows.insert(r, pull.vertex) = 1;
    term.targets.row(r) = pull.target.transpose();
    term.weights[r] = pull.weight;
  }
  term.rows.makeCompressed();
  return term;
}

double energy(const EnergyTerm& term, const Points& points) {
  double sum = 0;
  for (Eigen::Index r = 0; r < term.rows.rows(); ++r) {
    Vec3 residual = -term.targets.row(r).transpose();
    for (decltype(term.rows)::InnerIterator entry(term.rows, r); entry; ++entry)
      residual += entry.value() * points[entry.col()];
    sum += term.weights[r] * residual.squaredNorm();
  }
  return sum;
}

}  // namespace partwise
