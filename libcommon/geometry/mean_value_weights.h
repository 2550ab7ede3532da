#pragma once

#include <Eigen/Sparse>

#include "mesh/tri_mesh.h"

namespace partwise {

/// Row-major sparse matrix whose row i holds the weights of vertex i's neighbours.
using VertexWeights = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Mean-value weights w_ij = (tan(alpha_ij / 2) + tan(beta_ij / 2)) / |v_j - v_i|, rows scaled to sum 1
/// ([Wu11] Eq. (9)); alpha and beta are the angles at v_i beside edge ij (one of them at a boundary edge).
///
/// All weights are positive. Edges shorter than 1e-12 of the diagonal count as that long, so degenerate
/// facets give finite weights. Row i needs a facet at vertex i.
VertexWeights mean_value_weights(const Points& points, const Facets& facets);

/// Equal weights for all neighbours, rows summing to 1 ([Wu11] Eq. (6)).
VertexWeights uniform_weights(std::size_t vertex_count, const Facets& facets);

}  // namespace partwise
