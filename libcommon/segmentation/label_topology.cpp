#include "segmentation/label_topology.h"

#include <algorithm>

#include "mesh/facet_regions.h"

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
  LabelComponents components{facet_regions(mesh, labels), {}};
  std::vector<int>& component = components.of_facet;
  for (std::size_t f = 0; f < component.size(); ++f) {
    if (component[f] == static_cast<int>(f)) {
      component[f] = static_cast<int>(components.facets.size());
      components.facets.emplace_back();
    } else {
      component[f] = component[component[f]];
    }
    components.facets[component[f]].push_back(static_cast<int>(f));
  }
  return components;
}

}  // namespace partwise
