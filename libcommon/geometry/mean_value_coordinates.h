#pragma once

#include <vector>

#include "mesh/types.h"

namespace partwise {

/// Mean-value coordinates of a point with respect to a closed, outward oriented surface (Floater et al. 2005,
/// Ju et al. 2005): one per point of the surface, sum 1, and the coordinates times the points give `query`.
///
/// Non-negative for a query inside or on a convex surface; on the surface they are the barycentric
/// coordinates of the facet there.
std::vector<double> mean_value_coordinates(const Vec3& query, const Points& points, const Facets& facets);

}  // namespace partwise
