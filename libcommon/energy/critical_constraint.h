#pragma once

#include "energy/energy_term.h"

namespace partwise {

/// E_s = sum over critical vertices of |v_i - s_i|^2 ([Wu11] Eq. (17)): s_i is the critical point of the
/// target that is paired with vertex i of the compatible mesh.
EnergyTerm critical_constraint_term(int vertex_count, const std::vector<VertexTarget>& critical);

}  // namespace partwise
