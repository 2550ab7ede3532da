#pragma once

#include "mesh/types.h"

namespace partwise {

/// Whether two facets meet elsewhere than at their common vertices and edges, decided exactly.
///
/// They are neighbours when they name the same vertex; two vertices at one place are not the same. Neighbours
/// over an edge intersect when they lie in one plane and overlap. \pre both have area and are not the same
bool facets_intersect(const Points& points, const Facet& f, const Facet& g);

/// Whether the facet has area, decided exactly.
bool has_area(const Points& points, const Facet& facet);

}  // namespace partwise
