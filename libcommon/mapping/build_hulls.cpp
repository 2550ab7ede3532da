#include "mapping/build_hulls.h"

#include <algorithm>

#include "error.h"
#include "mapping/parallel_parts.h"

namespace partwise {
namespace {

/// The hull of the part's own vertices: a cap's centre is a mean of them and never extreme.
ConvexHull hull_of(const Part& part, const std::string& name) {
  const auto own = std::find(part.model_vertex.begin(), part.model_vertex.end(), -1);
  const Points& points = part.mesh.points();
  try {
    return convex_hull(Points(points.begin(), points.begin() + (own - part.model_vertex.begin())));
  } catch (const InputError& error) {
    throw InputError("part \"" + name + "\": " + error.what() +
                     "; give it more of the surface around it in the sketch");
  }
}

}  // namespace

HulledModel build_hulls(const SegmentedModel& model) {
  const int count = model.segmentation.part_count();
  HulledModel hulled{model, std::vector<Part>(), std::vector<ConvexHull>(count)};
  for (int k = 0; k < count; ++k) hulled.parts.push_back(extract_part(model, k));
  for_each_part(count,
                [&](int k) { hulled.hulls[k] = hull_of(hulled.parts[k], model.segmentation.names[k]); });
  return hulled;
}

}  // namespace partwise
