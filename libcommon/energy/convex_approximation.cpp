#include "energy/convex_approximation.h"

#include <numeric>

namespace partwise {
namespace {

constexpr double kRelaxation = 0.01;  // epsilon of Eq. (10)

}  // namespace

std::vector<HullApproach> approach_hull(const std::vector<int>& vertices, const Points& points,
                                        const Points& normals, const SurfaceIndex& hull,
                                        const Points& hull_facet_normals) {
  // Rays start a little behind the vertex, so that one on the hull itself does not look past it.
  const double behind = 1e-9 * bounding_box_diagonal(points);
  std::vector<HullApproach> approaches;
  for (const int i : vertices) {
    const Vec3& normal = normals[i];
    if (normal.isZero()) continue;
    std::optional<SurfaceHit> hit = hull.first_hit(points[i] - behind * normal, normal);
    if (!hit) hit = hull.first_hit(points[i] + behind * normal, -normal);
    if (!hit || hull_facet_normals[hit->point.facet].dot(normal) <= 0) continue;
    approaches.push_back({i, hit->position, (hit->position - points[i]).norm()});
  }
  return approaches;
}

EnergyTerm convex_approximation_term(const std::vector<HullApproach>& approaches,
                                     const std::vector<double>& ring_areas, double diagonal) {
  const double mean_area =
      std::accumulate(ring_areas.begin(), ring_areas.end(), 0.0) / static_cast<double>(ring_areas.size());
  std::vector<VertexTarget> pulls;
  pulls.reserve(approaches.size());
  for (const auto& [vertex, target, distance] : approaches) {
    const double nearness = 1 / (distance / diagonal + kRelaxation);
    pulls.push_back({vertex, target, nearness * ring_areas[vertex] / mean_area});
  }
  return point_term(static_cast<int>(ring_areas.size()), pulls);
}

}  // namespace partwise
