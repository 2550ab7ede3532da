#pragma once

#include <algorithm>

#include "mesh/types.h"

/// What tests do to the positions of a mesh's vertices.
namespace partwise::tests {

/// \param function from Vec3 to Vec3
template <class Function>
Points mapped(const Points& points, Function&& function) {
  Points result;
  result.reserve(points.size());
  for (const Vec3& point : points) result.push_back(function(point));
  return result;
}

/// Of vertices of equal number. \pre both have as many
inline double largest_distance(const Points& a, const Points& b) {
  double largest = 0;
  for (std::size_t v = 0; v < a.size(); ++v) largest = std::max(largest, (a[v] - b[v]).norm());
  return largest;
}

}  // namespace partwise::tests
