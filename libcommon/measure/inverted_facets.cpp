#include "measure/inverted_facets.h"

#include "geometry/normals.h"

namespace partwise {

std::vector<int> inverted_facets(const Points& points, const Facets& facets) {
  Points areas, around(points.size(), Vec3::Zero());
  areas.reserve(facets.size());
  for (const auto& [a, b, c] : facets) {
    areas.push_back(area_vector(points[a], points[b], points[c]));
    for (const int v : {a, b, c}) around[v] += areas.back();
  }
  std::vector<int> inverted;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    Vec3 others = -3 * areas[f];
    for (const int v : facets[f]) others += around[v];
    if (areas[f].dot(others) < 0) inverted.push_back(static_cast<int>(f));
  }
  return inverted;
}

}  // namespace partwise
