#include "mesh/submesh.h"

#include <utility>

namespace partwise {

Submesh extract_submesh(const TriMesh& mesh, const std::vector<bool>& inside) {
  std::vector<int> local(mesh.vertex_count(), -1);
  std::vector<int> model_vertex, model_facet;
  for (int f = 0; f < mesh.facet_count(); ++f) {
    if (!inside[f]) continue;
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

std::vector<bool> facets_labelled(const std::vector<int>& labels, int label) {
  std::vector<bool> inside;
  inside.reserve(labels.size());
  for (const int l : labels) inside.push_back(l == label);
  return inside;
}

}  // namespace partwise
