#pragma once

#include "energy/energy_term.h"
#include "geometry/mean_value_weights.h"

namespace partwise {

/// E_l = |L V|^2 ([Wu11] Eq. (7-9)): every vertex wants to be the weighted mean of its neighbours, rows
/// L_i = v_i - sum_j w_ij v_j.
///
/// `weights` are those of the undeformed part: mean_value_weights (Eq. (8-9)) or uniform_weights (Eq. (6)).
/// \pre its rows sum to 1
EnergyTerm laplacian_term(const VertexWeights& weights);

/// The Laplacian that keeps shape instead of smoothing it away: rows as above, targets the residuals of
/// `points`, so that the energy is 0 there (for deformations of a surface with detail, [Wu11] 6.1).
EnergyTerm laplacian_detail_term(const VertexWeights& weights, const Points& points);

}  // namespace partwise
