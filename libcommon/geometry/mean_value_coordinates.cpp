#include "geometry/mean_value_coordinates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "geometry/triangle_queries.h"

namespace partwise {
namespace {

/// Barycentric coordinates in the facet that `query` lies on (within rounding), if it lies on one.
std::optional<Vec3> on_facet(const Vec3& query, const Vec3& a, const Vec3& b, const Vec3& c) {
  const TriangleProximity closest = closest_on_triangle(query, a, b, c);
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  if (closest.squared_distance > 1e-18 * longest) return std::nullopt;
  return closest.barycentric;
}

/// The integral of the unit normals' directions over the facet's spherical triangle, in the basis of the
/// directions to its corners: half the sum over the edges of angle times the edge plane's normal (Stokes),
/// resolved along the three corners.
Vec3 facet_weights(const std::array<Vec3, 3>& to) {
  std::array<Vec3, 3> unit;
  for (int i = 0; i < 3; ++i) unit[i] = to[i].normalized();
  Vec3 mean = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    const Vec3 normal = unit[i].cross(unit[(i + 1) % 3]);
    const double sine = normal.norm();
    if (sine > 0) mean += 0.5 * std::atan2(sine, unit[i].dot(unit[(i + 1) % 3])) / sine * normal;
  }
  const double volume = to[0].dot(to[1].cross(to[2]));
  if (volume == 0) return Vec3::Zero();  // seen edge-on: covers no directions
  Vec3 weights;
  for (int i = 0; i < 3; ++i) weights[i] = mean.dot(to[(i + 1) % 3].cross(to[(i + 2) % 3])) / volume;
  return weights;
}

}  // namespace

std::vector<double> mean_value_coordinates(const Vec3& query, const Points& points, const Facets& facets) {
  std::vector<double> coordinates(points.size(), 0.0);
  for (const Facet& f : facets) {
    if (const auto share = on_facet(query, points[f[0]], points[f[1]], points[f[2]])) {
      std::fill(coordinates.begin(), coordinates.end(), 0.0);
      for (int i = 0; i < 3; ++i) coordinates[f[i]] += (*share)[i];
      return coordinates;
    }
    const Vec3 weights = facet_weights({points[f[0]] - query, points[f[1]] - query, points[f[2]] - query});
    for (int i = 0; i < 3; ++i) coordinates[f[i]] += weights[i];
  }
  double sum = 0;
  for (const double c : coordinates) sum += c;
  for (double& c : coordinates) c /= sum;
  return coordinates;
}

}  // namespace partwise
