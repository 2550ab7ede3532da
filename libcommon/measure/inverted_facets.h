#pragma once

#include <vector>

#include "mesh/types.h"

namespace partwise {

/// Facets that face against their surroundings: the normal makes more than a right angle with the sum of
/// the area vectors of the facets around its corners, itself left out. Needs no other mesh, unlike
/// flipped_facets; a facet at the tip of a spike may be counted too, so compare with a mesh at rest.
/// \return ascending facet indices
std::vector<int> inverted_facets(const Points& points, const Facets& facets);

}  // namespace partwise
