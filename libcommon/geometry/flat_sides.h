#pragma once

#include "mesh/types.h"

namespace partwise {

/// The same convex surface with every flat side of more than one facet cut into a fan around its vertex of
/// lowest index: of all triangulations of the flat sides always the same one.
///
/// Which facets share a plane is decided exactly. The facets' order is free.
/// \pre closed and convex, outward oriented, every vertex an extreme point
Facets fan_flat_sides(const Points& points, const Facets& facets);

}  // namespace partwise
