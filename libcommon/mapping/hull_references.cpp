#include "mapping/hull_references.h"

#include <cmath>
#include <numeric>

#include "geometry/normals.h"

namespace partwise {
namespace {

constexpr double kLeastQuality = 0.02;
constexpr double kLeastRelativeArea = 0.01;

}  // namespace

std::vector<ReferenceTriangle> hull_references(const TriMesh& mesh, double hull_area) {
  const std::vector<double> areas = facet_areas(mesh.points(), mesh.facets());
  const double scale = std::sqrt(hull_area / std::accumulate(areas.begin(), areas.end(), 0.0));
  const double least_area = kLeastRelativeArea * hull_area / mesh.facet_count();
  std::vector<ReferenceTriangle> references;
  references.reserve(areas.size());
  for (const auto& [a, b, c] : mesh.facets()) {
    references.push_back(ReferenceTriangle::from(scale * mesh.point(a), scale * mesh.point(b),
                                                 scale * mesh.point(c), kLeastQuality, least_area));
  }
  return references;
}

}  // namespace partwise
