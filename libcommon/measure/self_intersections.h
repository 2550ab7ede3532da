#pragma once

#include <utility>
#include <vector>

#include "mesh/types.h"

namespace partwise {

/// Pairs of facets that meet elsewhere than at their common vertices and edges, decided exactly.
///
/// Facets count as neighbours when they name the same vertex; two vertices at one place are not the same.
/// Neighbours over an edge intersect when they lie in one plane and overlap. Facets without area have no
/// pairs. \return pairs (smaller facet, larger facet), ascending
std::vector<std::pair<int, int>> self_intersections(const Points& points, const Facets& facets);

}  // namespace partwise
