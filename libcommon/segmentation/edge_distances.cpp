#include "segmentation/edge_distances.h"

#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace partwise {

std::vector<int> EdgeDistances::way_back(int vertex) const {
  std::vector<int> way;
  for (int v = vertex; v >= 0; v = previous[v]) way.push_back(v);
  return way;
}

int EdgeDistances::farthest() const {
  int best = -1;
  for (std::size_t v = 0; v < distance.size(); ++v) {
    if (distance[v] == std::numeric_limits<double>::infinity()) continue;
    if (best < 0 || distance[v] > distance[best]) best = static_cast<int>(v);
  }
  return best;
}

EdgeDistances edge_distances(const TriMesh& mesh, const std::vector<int>& starts,
                             const std::vector<bool>& may_pass) {
  EdgeDistances result{std::vector<double>(mesh.vertex_count(), std::numeric_limits<double>::infinity()),
                       std::vector<int>(mesh.vertex_count(), -1)};
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  for (const int v : starts) {
    result.distance[v] = 0;
    open.emplace(0, v);
  }
  while (!open.empty()) {
    const auto [distance, v] = open.top();
    open.pop();
    if (distance > result.distance[v]) continue;
    for (const OpenMesh::VertexHandle w : mesh.half_edges().vv_range(OpenMesh::VertexHandle(v))) {
      if (!may_pass.empty() && !may_pass[w.idx()]) continue;
      const double through = distance + (mesh.point(w.idx()) - mesh.point(v)).norm();
      if (through >= result.distance[w.idx()]) continue;
      result.distance[w.idx()] = through;
      result.previous[w.idx()] = v;
      open.emplace(through, w.idx());
    }
  }
  return result;
}

}  // namespace partwise
