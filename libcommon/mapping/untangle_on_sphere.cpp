#include "mapping/untangle_on_sphere.h"

#include <cmath>
#include <numeric>

#include "geometry/normals.h"

namespace partwise {
namespace {

constexpr int kScaleSmoothings = 8;
constexpr double kLeastQuality = 0.02;  // flatter reference facets count as equilateral

/// Per vertex: the logarithm of how much longer its surroundings are on the sphere than on the mesh.
std::vector<double> log_scales(const TriMesh& mesh, const Points& directions) {
  const int n = mesh.vertex_count();
  std::vector<double> here(n, 0.0), there(n, 0.0);
  for (const Facet& f : mesh.facets()) {
    const double area = area_vector(mesh.point(f[0]), mesh.point(f[1]), mesh.point(f[2])).norm();
    const double image = area_vector(directions[f[0]], directions[f[1]], directions[f[2]]).norm();
    for (const int v : f) {
      here[v] += area;
      there[v] += image;
    }
  }
  std::vector<double> scales(n, 0.0);
  for (int v = 0; v < n; ++v) {
    if (here[v] > 0 && there[v] > 0) scales[v] = std::log(there[v] / here[v]) / 2;
  }
  for (int i = 0; i < kScaleSmoothings; ++i) {
    const std::vector<double> before = scales;
    for (int v = 0; v < n; ++v) {
      double sum = 0;
      int count = 0;
      for (const auto w : mesh.half_edges().vv_range(OpenMesh::VertexHandle(v))) {
        sum += before[w.idx()];
        ++count;
      }
      if (count > 0) scales[v] = (before[v] + sum / count) / 2;
    }
  }
  return scales;
}

/// Per facet: its own shape, in the size of its surroundings on the sphere.
std::vector<ReferenceTriangle> sphere_references(const TriMesh& mesh, const Points& directions) {
  const std::vector<double> scales = log_scales(mesh, directions);
  const std::vector<double> areas = facet_areas(mesh.points(), mesh.facets());
  const double mean_area = std::accumulate(areas.begin(), areas.end(), 0.0) / mesh.facet_count();
  std::vector<ReferenceTriangle> references;
  references.reserve(areas.size());
  for (const Facet& f : mesh.facets()) {
    const double scale = std::exp((scales[f[0]] + scales[f[1]] + scales[f[2]]) / 3);
    references.push_back(ReferenceTriangle::from(scale * mesh.point(f[0]), scale * mesh.point(f[1]),
                                                 scale * mesh.point(f[2]), kLeastQuality,
                                                 0.01 * scale * scale * mean_area));
  }
  return references;
}

}  // namespace

UntangledMap untangle_on_sphere(const TriMesh& mesh, const Points& start, const std::vector<bool>& fixed) {
  Points directions = start;
  for (Vec3& direction : directions) direction.stableNormalize();
  return untangle(mesh, sphere_references(mesh, directions), UnitSphere(), directions, fixed);
}

}  // namespace partwise
