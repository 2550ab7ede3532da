#pragma once

#include <cstdint>

#include "mesh/types.h"

namespace partwise {

/// `count` points spread evenly over a surface: the surface is cut into `count` pieces of equal area, in the
/// order of the facets, and each piece holds one random point.
///
/// Every point stands for the same area, so plain means over points are area-weighted means. The points
/// depend on their arguments alone: the random numbers are integer hashes of seed and index, the same on
/// every machine. Facets without area hold no points; a surface without area has none at all. \pre count >=
/// 0, facets name vertices of `points`
Points sample_surface(const Points& points, const Facets& facets, int count, std::uint64_t seed);

}  // namespace partwise
