#pragma once

#include <vector>

#include "mesh/types.h"

namespace partwise {

/// Cuts a polygon into corners.size() - 2 triangles, with its orientation, by clipping the best-shaped ears.
///
/// Concave polygons are cut within their outline as seen along their mean normal; what is not simple or flat
/// is cut as well as can be.
/// \pre 3 <= corners.size(); time grows with its cube
std::vector<Facet> triangulate_polygon(const Points& points, std::vector<int> corners);

}  // namespace partwise
