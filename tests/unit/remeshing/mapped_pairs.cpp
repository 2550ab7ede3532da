#include "mapped_pairs.h"

#include <random>

#include "builders.h"
#include "mapping/build_hulls.h"
#include "mapping/hull_to_hull.h"
#include "mapping/map_to_hull.h"
#include "mesh/surface_walk.h"

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

CompatibleMesh shaken(const TriMesh& mesh, double size, unsigned seed) {
  std::vector<SurfacePoint> images(mesh.vertex_count());
  for (int f = 0; f < mesh.facet_count(); ++f) {
    for (int i = 0; i < 3; ++i) images[mesh.facet(f)[i]] = {f, Vec3::Unit(i)};
  }
  const SurfaceWalker walker(mesh);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-size, size);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.half_edges().is_boundary(OpenMesh::VertexHandle(v))) continue;
    const int next = mesh.half_edges().vv_range(OpenMesh::VertexHandle(v)).begin()->idx();
    const double edge = (mesh.point(next) - mesh.point(v)).norm();
    const Vec3 step(shift(random), shift(random), shift(random));
    images[v] = walker.towards(images[v], mesh.point(v) + edge * step);
  }
  SurfaceMap map(mesh, mesh, images);
  Points points = map.positions(mesh);
  const std::vector<int> labels(mesh.facet_count(), 0);
  return {mesh, mesh, std::move(points), std::move(map), labels, labels, {"all"}, {}, {}};
}

}  // namespace partwise::tests
