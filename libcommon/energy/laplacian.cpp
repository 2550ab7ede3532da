#include "energy/laplacian.h"

namespace partwise {

EnergyTerm laplacian_term(const VertexWeights& weights) {
  VertexWeights identity(weights.rows(), weights.cols());
  identity.setIdentity();
  return {identity - weights, Eigen::MatrixX3d::Zero(weights.rows(), 3),
          Eigen::VectorXd::Ones(weights.rows())};
}

EnergyTerm laplacian_detail_term(const VertexWeights& weights, const Points& points) {
  EnergyTerm term = laplacian_term(weights);
  Eigen::MatrixX3d positions(points.size(), 3);
  for (std::size_t i = 0; i < points.size(); ++i) positions.row(i) = points[i].transpose();
  term.targets = term.rows * positions;
  return term;
}

}  // namespace partwise
