#include "report/surface_fields.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/normals.h"
#include "geometry/surface_index.h"
#include "measure/distortion.h"

namespace partwise::report {

namespace {

constexpr double kSmallest = 1e-3;  // singular values are clamped, as in the figures
constexpr double kLargest = 1e3;

template <class Value>
std::vector<float> in_parallel(std::size_t count, const Value& value) {
  std::vector<float> values(count);
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) { values[i] = static_cast<float>(value(i)); });
  return values;
}

std::array<Vec3, 3> corners(const Points& points, const Facet& facet, double scale = 1) {
  return {scale * points[facet[0]], scale * points[facet[1]], scale * points[facet[2]]};
}

double total_area(const Points& points, const Facets& facets) {
  const std::vector<double> areas = facet_areas(points, facets);
  return std::accumulate(areas.begin(), areas.end(), 0.0);
}

}  // namespace

std::vector<float> distances_to_target(const CompatibleMesh& mesh, const std::vector<int>& facets) {
  const SurfaceIndex target(mesh.target);
  const double diagonal = mesh.target.diagonal();
  return in_parallel(facets.size(), [&](std::size_t i) {
    const auto [a, b, c] = corners(mesh.points, mesh.source.facet(facets[i]));
    return target.closest((a + b + c) / 3).distance / diagonal;
  });
}

std::vector<float> distances_to_compatible(const CompatibleMesh& mesh, const std::vector<int>& vertices) {
  const SurfaceIndex compatible(mesh.points, mesh.source.facets());
  const double diagonal = mesh.target.diagonal();
  return in_parallel(vertices.size(), [&](std::size_t i) {
    return compatible.closest(mesh.target.point(vertices[i])).distance / diagonal;
  });
}

FacetDistortion facet_distortion(const CompatibleMesh& mesh, const std::vector<int>& facets) {
  const double source_area = total_area(mesh.source.points(), mesh.source.facets());
  const double area = total_area(mesh.points, mesh.source.facets());
  const double scale = source_area > 0 ? std::sqrt(area / source_area) : 1;
  FacetDistortion result;
  for (const int f : facets) {
    const auto values = singular_values(corners(mesh.source.points(), mesh.source.facet(f), scale),
                                        corners(mesh.points, mesh.source.facet(f)));
    const double s1 = std::clamp(values[0], kSmallest, kLargest);
    const double s2 = std::clamp(values[1], kSmallest, kLargest);
    result.dirichlet.push_back(static_cast<float>(s1 * s1 + s2 * s2 + 1 / (s1 * s1) + 1 / (s2 * s2)));
    result.area.push_back(static_cast<float>(std::log2(s1 * s2)));
  }
  return result;
}

double quantile(std::vector<float> values, double share) {
  if (values.empty()) return 0;
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

}  // namespace partwise::report
