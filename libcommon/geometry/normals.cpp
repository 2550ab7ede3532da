#include "geometry/normals.h"

#include <cmath>

namespace partwise {
namespace {

/// Angle between two directions, in radians; accurate for small and for nearly straight angles.
double angle_between(const Vec3& u, const Vec3& v) {
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

}  // namespace

Vec3 area_vector(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b - a).cross(c - a);
}

Points facet_normals(const Points& points, const Facets& facets) {
  Points normals;
  normals.reserve(facets.size());
  for (const auto& [a, b, c] : facets) {
    normals.push_back(area_vector(points[a], points[b], points[c]).stableNormalized());
  }
  return normals;
}

Points vertex_normals(const Points& points, const Facets& facets) {
  Points normals(points.size(), Vec3::Zero());
  for (const Facet& f : facets) {
    const Vec3 normal = area_vector(points[f[0]], points[f[1]], points[f[2]]).stableNormalized();
    for (int i = 0; i < 3; ++i) {
      const Vec3& corner = points[f[i]];
      normals[f[i]] +=
          angle_between(points[f[(i + 1) % 3]] - corner, points[f[(i + 2) % 3]] - corner) * normal;
    }
  }
  for (Vec3& normal : normals) normal.stableNormalize();
  return normals;
}

std::vector<double> facet_areas(const Points& points, const Facets& facets) {
  std::vector<double> areas;
  areas.reserve(facets.size());
  for (const auto& [a, b, c] : facets)
    areas.push_back(area_vector(points[a], points[b], points[c]).norm() / 2);
  return areas;
}

std::vector<double> ring_areas(const Points& points, const Facets& facets) {
  const std::vector<double> areas = facet_areas(points, facets);
  std::vector<double> rings(points.size(), 0.0);
  for (std::size_t f = 0; f < facets.size(); ++f) {
    for (const int v : facets[f]) rings[v] += areas[f];
  }
  return rings;
}

}  // namespace partwise
