// Writes a hull map with folds: sample_hullmap OUT.ply
//
// A capsule in two parts, "left" and "right", every part on its hull; one vertex of the first part is pushed
// to the far side of the hull, so that the facets around it fold over.
#include <algorithm>

#include "builders.h"
#include "io/stage_documents.h"
#include "mapping/build_hulls.h"
#include "mapping/map_to_hull.h"

using namespace partwise;

namespace {

SegmentedModel two_parts() {
  const TriMesh mesh = tests::capsule(4, 12, 10);
  std::vector<int> labels;
  for (const Facet& f : mesh.facets()) {
    labels.push_back(mesh.point(f[0]).z() + mesh.point(f[1]).z() + mesh.point(f[2]).z() > 0 ? 1 : 0);
  }
  return {mesh, trace_boundaries(mesh, {"left", "right"}, labels), {}, {}, std::vector<Concavity>(2)};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  HullMap map = map_to_hull(build_hulls(two_parts())).map;
  Points& images = map.images[0];
  const auto [lowest, highest] = std::minmax_element(
      images.begin(), images.end(), [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); });
  *lowest = *highest;
  io::write_document(argv[1], io::to_document(map), true);
}
