#include "remeshing/domain_average.h"

#include <set>

#include "geometry/mean_value_coordinates.h"

namespace partwise {
namespace {

double mean_edge_length(const Points& points, const Facets& facets) {
  double sum = 0;
  for (const Facet& f : facets) {
    for (int i = 0; i < 3; ++i) sum += (points[f[(i + 1) % 3]] - points[f[i]]).norm();
  }
  return sum / (3.0 * static_cast<double>(facets.size()));
}

/// The points as combinations of the hull's vertices, by their mean-value coordinates.
Points through_hull(const Points& points, const ConvexHull& hull) {
  Points result;
  for (const Vec3& point : points) {
    const std::vector<double> coordinates = mean_value_coordinates(point, hull.points, hull.facets);
    result.emplace_back(Vec3::Zero());
    for (std::size_t i = 0; i < coordinates.size(); ++i) result.back() += coordinates[i] * hull.points[i];
  }
  return result;
}

}  // namespace

DomainAverage::DomainAverage(const Part& part, const Points& images, const ConvexHull& hull,
                             Coordinates coordinates, double radius)
    : part_(part),
      images_(images),
      radius_(radius * mean_edge_length(images, part.mesh.facets())),
      positions_(coordinates == Coordinates::mean_value ? through_hull(part.mesh.points(), hull)
                                                        : part.mesh.points()) {}

Vec3 DomainAverage::at(const Vec3& image, const SurfacePoint& located) const {
  const Facet& facet = part_.mesh.facet(located.facet);
  std::vector<int> front(facet.begin(), facet.end());
  std::set<int> seen(front.begin(), front.end());
  Vec3 sum = Vec3::Zero();
  double weights = 0;
  while (!front.empty()) {
    const int vertex = front.back();
    front.pop_back();
    const double weight = 1 - (images_[vertex] - image).norm() / radius_;
    if (weight <= 0) continue;
    if (!part_.is_cap_vertex(vertex)) {
      sum += weight * positions_[vertex];
      weights += weight;
    }
    for (const auto next : part_.mesh.half_edges().vv_range(OpenMesh::VertexHandle(vertex))) {
      if (seen.insert(next.idx()).second) front.push_back(next.idx());
    }
  }
  return weights > 0 ? Vec3(sum / weights) : position(part_.mesh, located);
}

}  // namespace partwise
