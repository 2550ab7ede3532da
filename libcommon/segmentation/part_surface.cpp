#include "segmentation/part_surface.h"

#include <utility>

namespace partwise {

PartSurface part_surface(const TriMesh& mesh, const std::vector<int>& labels, int part) {
  std::vector<int> local(mesh.vertex_count(), -1);
  std::vector<int> model_vertex, model_facet;
  for (int f = 0; f < mesh.facet_count(); ++f) {
    if (labels[f] != part) continue;
    model_facet.push_back(f);
    for (const int v : mesh.facet(f)) local[v] = 0;
  }
  Points points;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (local[v] < 0) continue;
    local[v] = static_cast<int>(points.size());
    model_vertex.push_back(v);
    points.push_back(mesh.point(v));
  }
  Facets facets;
  facets.reserve(model_facet.size());
  for (const int f : model_facet) {
    const auto& [a, b, c] = mesh.facet(f);
    facets.push_back({local[a], local[b], local[c]});
  }
  return {TriMesh(std::move(points), std::move(facets)), std::move(model_vertex), std::move(model_facet)};
}

}  // namespace partwise
