#include "mapping/untangle_on_hull.h"

#include "mapping/hull_references.h"
#include "mapping/smooth_hull.h"

namespace partwise {

UntangledMap untangle_on_hull(const TriMesh& mesh, const StarHull& hull, const Points& start,
                              const std::vector<bool>& fixed) {
  constexpr double kRounding = 0.1;
  UntangledMap result =
      untangle(mesh, hull_references(mesh, hull.area()), SmoothHull(hull, kRounding), start, fixed);
  int hint = 0;
  for (Vec3& image : result.images) {
    const StarHull::Place place = hull.project(image, hint);
    image = place.position;
    hint = place.facet;
  }
  return result;
}

}  // namespace partwise
