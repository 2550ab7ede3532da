#include "measure/surface_field.h"

#include <algorithm>
#include <cmath>

#include "error.h"
#include "geometry/normals.h"
#include "geometry/surface_index.h"
#include "measure/distortion.h"
#include "measure/flipped_facets.h"
#include "measure/self_intersections.h"

namespace partwise {

double SurfaceField::share(double value) const {
  const double share =
      logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
  return share > 0 ? std::min(share, 1.0) : 0;  // NaN is low
}

SurfaceField distance_field(const CompatibleMesh& mesh) {
  const double diagonal = mesh.target.diagonal();
  if (!(diagonal > 0)) throw InputError("the target's vertices are all in one place");
  SurfaceField field{"distance of the target to the compatible mesh, over the target's diagonal",
                     0,
                     0.01,
                     false,
                     mesh.target.points(),
                     mesh.target.facets(),
                     {}};
  const SurfaceIndex surface(mesh.points, mesh.source.facets());
  for (const Vec3& p : field.points) field.values.push_back(surface.closest(p).distance / diagonal);
  return field;
}

SurfaceField distortion_field(const CompatibleMesh& mesh) {
  SurfaceField field{"symmetric Dirichlet energy of the map, 4 is an isometry",
                     4,
                     40,
                     true,
                     mesh.points,
                     mesh.source.facets(),
                     std::vector<double>(mesh.points.size(), 0.0)};
  const std::vector<double> energies =
      facet_dirichlet_energies(mesh.source.points(), mesh.points, field.facets);
  const std::vector<double> areas = facet_areas(mesh.source.points(), field.facets);
  std::vector<double> weights(mesh.points.size(), 0.0);
  for (std::size_t f = 0; f < areas.size(); ++f) {
    if (!(areas[f] > 0)) continue;
    for (const int v : field.facets[f]) {
      field.values[v] += areas[f] * energies[f];
      weights[v] += areas[f];
    }
  }
  for (std::size_t v = 0; v < weights.size(); ++v) {
    field.values[v] = weights[v] > 0 ? field.values[v] / weights[v] : field.low;
  }
  return field;
}

SurfaceField fold_field(const CompatibleMesh& mesh) {
  SurfaceField field{
      "2: beside a facet that faces against the target; 1: beside a facet that intersects another",
      0,
      2,
      false,
      mesh.points,
      mesh.source.facets(),
      std::vector<double>(mesh.points.size(), 0.0)};
  auto mark = [&](int facet, double value) {
    for (const int v : field.facets[facet]) field.values[v] = std::max(field.values[v], value);
  };
  for (const auto& [f, g] : self_intersections(mesh.points, field.facets)) {
    mark(f, 1);
    mark(g, 1);
  }
  for (const int f : flipped_facets(mesh.points, field.facets, mesh.map, mesh.target)) mark(f, 2);
  return field;
}

}  // namespace partwise
