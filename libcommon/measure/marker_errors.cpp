#include "measure/marker_errors.h"

namespace partwise {

std::vector<double> marker_errors(const std::vector<MarkerPair>& markers, const Facets& source_facets,
                                  const Points& points, const TriMesh& target) {
  std::vector<double> errors;
  errors.reserve(markers.size());
  for (const MarkerPair& marker : markers) {
    Vec3 carried = Vec3::Zero();
    for (int i = 0; i < 3; ++i) {
      carried += marker.source.barycentric[i] * points[source_facets[marker.source.facet][i]];
    }
    errors.push_back((carried - position(target, marker.target)).norm());
  }
  return errors;
}

}  // namespace partwise
