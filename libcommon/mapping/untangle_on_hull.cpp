#include "mapping/untangle_on_hull.h"

#include "mapping/hull_references.h"
#include "mapping/smooth_hull.h"

namespace partwise {

UntangledMap untangle_on_hull(const TriMesh& mesh, const StarHull& hull, const Points& start,
                              const std::vector<bool>& fixed) {
  constexpr double kRounding = 0.1;
  UntangledMap result =
      untangle(mesh, hull_references(mesh, hull.area()), SmoothHull(hull, kRounding), start, fixed);
  const std::vector<StarHull::Place> places = hull.project(result.images);
  for (std::size_t v = 0; v < places.size(); ++v) result.images[v] = places[v].position;
  return result;
}

}  // namespace partwise
