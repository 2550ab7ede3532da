// Writes a cross map: sample_crossmap OUT.ply [halves]
//
// A cube of 768 facets on a bumpy sphere of 1,568, centrally projected, as one part or as two halves that
// meet at z = 0; a marker on the corner of each octant.
#include <string>

#include "builders.h"
#include "convex_pairs.h"
#include "geometry/surface_index.h"
#include "io/stage_documents.h"

using namespace partwise;

namespace {

SurfacePoint outermost(const TriMesh& mesh, const Vec3& direction) {
  SurfacePoint best;
  double farthest = 0;
  for (int f = 0; f < mesh.facet_count(); ++f) {
    for (int i = 0; i < 3; ++i) {
      const double along = mesh.point(mesh.facet(f)[i]).normalized().dot(direction);
      if (along <= farthest + 1e-12) continue;
      farthest = along;
      best = {f, Vec3::Unit(i)};
    }
  }
  return best;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const TriMesh source = tests::cube(8), target = tests::bumpy_sphere(14, 0.4);
  const SurfaceIndex surface(target);
  std::vector<MarkerPair> markers;
  for (int octant = 0; octant < 8; ++octant) {
    const Vec3 direction = Vec3(octant & 1 ? 1 : -1, octant & 2 ? 1 : -1, octant & 4 ? 1 : -1).normalized();
    const SurfacePoint image = surface.first_hit(Vec3::Zero(), direction)->point;
    markers.push_back({"corner " + std::to_string(octant), outermost(source, direction), image});
  }
  const bool cut = argc > 2 && std::string(argv[2]) == "halves";
  const CrossMap map = cut ? tests::projected_pair(tests::halves(source), tests::halves(target), markers)
                           : tests::projected_pair(tests::whole(source), tests::whole(target), markers);
  io::write_document(argv[1], io::to_document(map), true);
}
