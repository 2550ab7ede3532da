#pragma once

#include "energy/energy_term.h"

namespace partwise {

/// E_g = sum over G of |v_i - g_i|^2 ([Wu11] Eq. (12)): vertices whose place on the hull is known, such as
/// the part's hull vertices, its concave extreme points, and markers.
EnergyTerm global_constraint_term(int vertex_count, const std::vector<VertexTarget>& constraints);

}  // namespace partwise
