#include "segmentation/label_topology.h"

#include <algorithm>

namespace partwise {

std::vector<int> facets_around(const TriMesh& mesh, int vertex) {
  std::vector<int> facets;
  for (const OpenMesh::HalfedgeHandle h : mesh.half_edges().voh_range(OpenMesh::VertexHandle(vertex))) {
    facets.push_back(mesh.half_edges().face_handle(h).idx());  // -1 when there is none
  }
  return facets;
}

int extra_fans(const TriMesh& mesh, const std::vector<int>& labels, int vertex) {
  std::vector<int> runs;
  for (const OpenMesh::HalfedgeHandle h : mesh.half_edges().voh_range(OpenMesh::VertexHandle(vertex))) {
    const int facet = mesh.half_edges().face_handle(h).idx();
    const int label = facet < 0 ? kOutside : labels[facet];
    if (runs.empty() || runs.back() != label) runs.push_back(label);
  }
  if (runs.size() > 1 && runs.front() == runs.back()) runs.pop_back();
  if (runs.size() < 4) return 0;
  const auto count = static_cast<int>(runs.size());
  std::sort(runs.begin(), runs.end());
  return count - static_cast<int>(std::unique(runs.begin(), runs.end()) - runs.begin());
}

LabelComponents label_components(const TriMesh& mesh, const std::vector<int>& labels) {
  LabelComponents components{std::vector<int>(labels.size(), -1), {}};
  for (int seed = 0; seed < mesh.facet_count(); ++seed) {
    if (components.of_facet[seed] >= 0) continue;
    const int index = static_cast<int>(components.facets.size());
    std::vector<int> facets{seed};
    components.of_facet[seed] = index;
    for (std::size_t i = 0; i < facets.size(); ++i) {
      OpenMesh::HalfedgeHandle h = mesh.half_edges().halfedge_handle(OpenMesh::FaceHandle(facets[i]));
      for (int side = 0; side < 3; ++side, h = mesh.half_edges().next_halfedge_handle(h)) {
        const int f = mesh.half_edges().opposite_face_handle(h).idx();
        if (f < 0 || components.of_facet[f] >= 0 || labels[f] != labels[seed]) continue;
        components.of_facet[f] = index;
        facets.push_back(f);
      }
    }
    components.facets.push_back(std::move(facets));
  }
  return components;
}

}  // namespace partwise
