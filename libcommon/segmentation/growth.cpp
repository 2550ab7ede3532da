#include "segmentation/growth.h"

#include <algorithm>
#include <queue>
#include <tuple>

#include "geometry/normals.h"

namespace partwise {
namespace {

/// A possible step to `vertex`; ordered so that a priority queue yields the cheapest first.
struct Step {
  double cost;
  int part;
  int vertex;
  bool operator<(const Step& other) const {
    return std::tie(other.cost, other.part, other.vertex) < std::tie(cost, part, vertex);
  }
};

double step_cost(const Vec3& from, const Vec3& to, const Vec3& normal_from, const Vec3& normal_to) {
  const double cosine = normal_from.dot((to - from).stableNormalized());  // [Wu11] Eq. (1)
  const double sine = normal_from.cross(normal_to).norm();                // [Wu11] Eq. (2)
  return (1 + cosine) * (1 + sine);                                       // [Wu11] Eq. (3)
}

}  // namespace

std::vector<int> grow_regions(const TriMesh& mesh, const Seeds& seeds) {
  const Points normals = vertex_normals(mesh.points(), mesh.facets());
  std::vector<int> part = seeds.vertex_part;
  std::priority_queue<Step> queue;
  auto push_neighbours = [&](int s) {
    for (const OpenMesh::VertexHandle t : mesh.half_edges().vv_range(OpenMesh::VertexHandle(s))) {
      if (part[t.idx()] != kUnseeded) continue;
      queue.push(
          {step_cost(mesh.point(s), mesh.point(t.idx()), normals[s], normals[t.idx()]), part[s], t.idx()});
    }
  };
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (part[v] != kUnseeded) push_neighbours(v);
  }
  while (!queue.empty()) {
    const Step step = queue.top();
    queue.pop();
    if (part[step.vertex] != kUnseeded) continue;
    part[step.vertex] = step.part;
    push_neighbours(step.vertex);
  }
  std::vector<int> labels;
  labels.reserve(mesh.facet_count());
  for (const auto& [a, b, c] : mesh.facets()) labels.push_back(std::max({part[a], part[b], part[c]}));
  return labels;
}

}  // namespace partwise
