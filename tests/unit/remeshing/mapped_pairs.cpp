#include "mapped_pairs.h"

#include "builders.h"
#include "mapping/build_hulls.h"
#include "mapping/hull_to_hull.h"
#include "mapping/map_to_hull.h"

namespace partwise::tests {
namespace {

/// A torus around the z axis in two halves that meet twice.
SegmentedModel half_tori(const TriMesh& mesh) {
  std::vector<int> labels;
  for (const Facet& f : mesh.facets()) {
    labels.push_back(mesh.point(f[0]).x() + mesh.point(f[1]).x() + mesh.point(f[2]).x() > 0 ? 1 : 0);
  }
  return {mesh, trace_boundaries(mesh, {"left", "right"}, labels), {}, {}, {}};
}

}  // namespace

Reconstruction mapped_by_hulls(const SegmentedModel& source, const SegmentedModel& target) {
  auto on_hulls = [](const SegmentedModel& model) { return map_to_hull(build_hulls(model)).map; };
  return reconstruct(map_hull_to_hull(on_hulls(source), on_hulls(target)).map);
}

CompatibleMesh torus_pair() {
  return mapped_by_hulls(half_tori(torus(1, 0.3, 20, 10)), half_tori(torus(1, 0.45, 24, 14))).mesh;
}

}  // namespace partwise::tests
