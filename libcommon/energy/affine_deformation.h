#pragma once

#include "energy/energy_term.h"

namespace partwise {

/// The energy of a deformation that is nearly affine around every vertex (Amberg et al. 2007, with the
/// places as unknowns beside the maps): the sum over edges ij of
///   |x_j - x_i - A_i (p_j - p_i)|^2 + |x_i - x_j - A_j (p_i - p_j)|^2 + h^2 |A_i - A_j|^2,
/// p the places of the vertices at rest, h the mean length of edges. 0 for an affine map of the whole.
///
/// The unknowns are x, A: four vectors per vertex, 4 v for the place and 4 v + 1 ... 4 v + 3 for the columns
/// of h A_v, all in units of length. They are determined up to an affine map: see affine_rest_term.
EnergyTerm affine_deformation_term(const Points& rest, const Facets& facets);

/// Sum of |A_v - 1|^2 h^2: to be added with a tiny weight, for what other terms leave open (a flat mesh).
EnergyTerm affine_rest_term(const Points& rest, const Facets& facets);

}  // namespace partwise
