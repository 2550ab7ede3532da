#pragma once

#include "energy/energy_term.h"

namespace partwise {

/// E_b = sum over boundary vertices of |v_i - b_i|^2 ([Wu11] Eq. (14)): a source boundary vertex sits at the
/// same fraction of arc length of the target's boundary. Both parts at a boundary must be given the same b_i
/// (as points of the target's mesh), which makes the whole map continuous.
EnergyTerm boundary_correspondence_term(int vertex_count, const std::vector<VertexTarget>& boundary);

}  // namespace partwise
