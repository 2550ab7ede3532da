// Writes a compatible mesh whose figures are known: sample_compatible OUT.ply [shift]
//
// Source is the sphere of 800 facets, target the bumpy sphere of as many, vertex i on vertex i. With a shift
// the points, not the map, are moved along z. The metrics say that the maps onto hulls have 3 folds in all.
#include <cstdlib>

#include "builders.h"
#include "io/stage_documents.h"

using namespace partwise;

namespace {

io::Json hull_map(int folds) {
  return {{"one_to_one", folds == 0}, {"parts", {{"whole", {{"folds", folds}}}}}};
}

CompatibleMesh sample(double shift) {
  const TriMesh source = tests::sphere(10), target = tests::bumpy_sphere(10, 0.2);
  std::vector<SurfacePoint> images(source.vertex_count());
  for (int f = 0; f < target.facet_count(); ++f) {
    for (int i = 0; i < 3; ++i) images[target.facet(f)[i]] = {f, Vec3::Unit(i)};
  }
  Points points = target.points();
  for (Vec3& point : points) point.z() += shift;
  const std::vector<int> labels(source.facet_count(), 0);
  const SurfacePoint pole{0, Vec3::Unit(0)};
  return {source, target, points,    SurfaceMap(source, target, images),
          labels, labels, {"whole"}, {{"pole", pole, pole}},
          {}};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  io::Document document = io::to_document(sample(argc > 2 ? std::atof(argv[2]) : 0));
  document.metadata["metrics"] = {{"source", {{"map-to-hull", hull_map(1)}}},
                                  {"target", {{"map-to-hull", hull_map(0)}}},
                                  {"hull-to-hull", hull_map(2)},
                                  {"reconstruct", {{"boundary_gap_max", 0.0}}}};
  io::write_document(argv[1], document, true);
}
