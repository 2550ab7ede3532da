#include "segmentation/patch_graph.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "geometry/normals.h"
#include "segmentation/crease_field.h"
#include "segmentation/facet_hierarchy.h"

namespace partwise {
namespace {

void add_borders(const TriMesh& mesh, const std::vector<int>& patch_of, PatchGraph& graph) {
  const HalfEdges& half_edges = mesh.half_edges();
  const auto add = [&](int from, int to, double length) {
    const auto begin = graph.neighbour.begin() + graph.first[from];
    const auto link = std::find(begin, graph.neighbour.begin() + graph.first[from + 1], to);
    graph.border[link - graph.neighbour.begin()] += length;
  };
  for (int e = 0; e < static_cast<int>(half_edges.n_edges()); ++e) {
    const auto h = half_edges.halfedge_handle(OpenMesh::EdgeHandle(e), 0);
    const int left = half_edges.face_handle(h).idx(), right = half_edges.opposite_face_handle(h).idx();
    if (left < 0 || right < 0) {
      graph.rim[patch_of[std::max(left, right)]] += edge_length(mesh, e);
    } else if (patch_of[left] != patch_of[right]) {
      const double length = edge_length(mesh, e);
      add(patch_of[left], patch_of[right], length);
      add(patch_of[right], patch_of[left], length);
    }
  }
}

}  // namespace

PatchGraph patch_graph(const TriMesh& mesh, int most) {
  const FacetHierarchy hierarchy(mesh, most);
  const int top = static_cast<int>(hierarchy.levels().size()) - 1;
  const FacetHierarchy::Level& level = hierarchy.levels()[top];
  const std::vector<int> patch_of = hierarchy.nodes_of_facets(top);
  const auto count = static_cast<std::size_t>(level.node_count());
  PatchGraph graph{level.first,
                   level.neighbour,
                   std::vector<double>(level.neighbour.size(), 0.0),
                   std::vector<double>(count, 0.0),
                   std::vector<double>(count, 0.0),
                   Points(count, Vec3::Zero()),
                   std::vector<int>(count, -1)};
  const std::vector<double> areas = facet_areas(mesh.points(), mesh.facets());
  for (int f = 0; f < mesh.facet_count(); ++f) {
    const auto& [a, b, c] = mesh.facet(f);
    // A facet without area counts a little, so that a patch of such has a centre, too.
    const double weight = std::max(areas[f], std::numeric_limits<double>::min());
    graph.area[patch_of[f]] += weight;
    graph.centre[patch_of[f]] += weight * ((mesh.point(a) + mesh.point(b) + mesh.point(c)) / 3);
  }
  for (std::size_t i = 0; i < count; ++i) graph.centre[i] /= graph.area[i];
  for (int f = 0; f < mesh.facet_count(); ++f) {
    const Vec3& centre = graph.centre[patch_of[f]];
    int& nearest = graph.vertex[patch_of[f]];
    for (const int v : mesh.facet(f)) {
      const bool nearer = nearest < 0 || (mesh.point(v) - centre).squaredNorm() <
                                             (mesh.point(nearest) - centre).squaredNorm();
      if (nearer) nearest = v;
    }
  }
  add_borders(mesh, patch_of, graph);
  return graph;
}

PatchWays patch_ways(const PatchGraph& graph, const std::vector<int>& starts,
                     const std::vector<bool>& may_pass) {
  PatchWays ways{{},
                 std::vector<double>(graph.count(), std::numeric_limits<double>::infinity()),
                 std::vector<int>(graph.count(), -1)};
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const int i : starts) {
    ways.distance[i] = 0;
    queue.emplace(0.0, i);
  }
  std::vector<bool> is_done(graph.count(), false);
  while (!queue.empty()) {
    const int i = queue.top().second;
    queue.pop();
    if (is_done[i]) continue;
    is_done[i] = true;
    ways.order.push_back(i);
    for (int k = graph.first[i]; k < graph.first[i + 1]; ++k) {
      const int j = graph.neighbour[k];
      const double distance = ways.distance[i] + (graph.centre[j] - graph.centre[i]).norm();
      if (!may_pass[j] || distance >= ways.distance[j]) continue;
      ways.distance[j] = distance;
      ways.previous[j] = i;
      queue.emplace(distance, j);
    }
  }
  return ways;
}

std::vector<std::vector<int>> connected_groups(const PatchGraph& graph, const std::vector<bool>& inside) {
  std::vector<std::vector<int>> groups;
  std::vector<double> areas;
  std::vector<bool> seen(graph.count(), false);
  for (int start = 0; start < graph.count(); ++start) {
    if (!inside[start] || seen[start]) continue;
    std::vector<int> group{start};
    double area = 0;
    seen[start] = true;
    for (std::size_t done = 0; done < group.size(); ++done) {
      const int i = group[done];
      area += graph.area[i];
      for (int k = graph.first[i]; k < graph.first[i + 1]; ++k) {
        const int j = graph.neighbour[k];
        if (!inside[j] || seen[j]) continue;
        seen[j] = true;
        group.push_back(j);
      }
    }
    groups.push_back(std::move(group));
    areas.push_back(area);
  }
  const auto largest = std::max_element(areas.begin(), areas.end());
  if (largest != areas.end()) std::swap(groups.front(), groups[largest - areas.begin()]);
  return groups;
}

}  // namespace partwise
