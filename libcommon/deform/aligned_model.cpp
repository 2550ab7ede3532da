#include "deform/aligned_model.h"

#include <cmath>
#include <numeric>

#include "deform/facet_transform.h"
#include "geometry/normals.h"

namespace partwise {
namespace {

Vec3 mean(const Points& points) {
  return std::accumulate(points.begin(), points.end(), Vec3(Vec3::Zero())) /
         static_cast<double>(points.size());
}

}  // namespace

double surface_area(const Points& points, const Facets& facets) {
  const std::vector<double> areas = facet_areas(points, facets);
  return std::accumulate(areas.begin(), areas.end(), 0.0);
}

Points aligned_model(const Points& points, const Points& first, const Facets& facets) {
  const Vec3 from = mean(points), to = mean(first);
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  for (std::size_t v = 0; v < points.size(); ++v) {
    products += (first[v] - to) * (points[v] - from).transpose();
  }
  const Eigen::Matrix3d turn = nearest_rotation(products).value_or(Eigen::Matrix3d::Identity());
  const double area = surface_area(points, facets);
  const double scale = area > 0 ? std::sqrt(surface_area(first, facets) / area) : 1;
  Points aligned;
  aligned.reserve(points.size());
  for (const Vec3& point : points) aligned.push_back(to + scale * (turn * (point - from)));
  return aligned;
}

}  // namespace partwise
