#include "measure/degenerate_facets.h"

#include <algorithm>
#include <numeric>

#include "geometry/normals.h"

namespace partwise {
namespace {

double longest_edge_squared(const Vec3& a, const Vec3& b, const Vec3& c) {
  return std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
}

}  // namespace

std::vector<int> degenerate_facets(const Points& points, const Facets& facets,
                                   const DegenerateThresholds& thresholds) {
  const std::vector<double> areas = facet_areas(points, facets);
  const double total = std::accumulate(areas.begin(), areas.end(), 0.0);
  const double smallest_area = thresholds.area * total / static_cast<double>(facets.size());
  std::vector<int> degenerate;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const auto& [a, b, c] = facets[f];
    // Altitude over longest edge e is 2 area / e^2.
    const double smallest_flat =
        thresholds.altitude * longest_edge_squared(points[a], points[b], points[c]) / 2;
    if (areas[f] <= smallest_area || areas[f] <= smallest_flat) degenerate.push_back(static_cast<int>(f));
  }
  return degenerate;
}

}  // namespace partwise
