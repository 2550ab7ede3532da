#include "segmentation/label_repair.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "error.h"
#include "segmentation/label_topology.h"
#include "segmentation/relabelling.h"

namespace partwise {
namespace {

using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

constexpr int kLargestBall = 4;

/// The component that stays, per label: most seeded area, then most area, then first facet.
std::vector<int> main_components(const LabelComponents& components, const Relabelling& relabelling,
                                 const std::vector<std::string>& names) {
  std::vector<int> main(names.size(), -1);
  std::vector<std::pair<double, double>> best(names.size(), {-1, -1});
  for (std::size_t c = 0; c < components.facets.size(); ++c) {
    const int label = relabelling.labels()[components.facets[c].front()];
    const std::pair size(relabelling.seeded_area(components.facets[c], label),
                         relabelling.area(components.facets[c]));
    if (size <= best[label]) continue;
    best[label] = size;
    main[label] = static_cast<int>(c);
  }
  for (std::size_t part = 0; part < names.size(); ++part) {
    if (main[part] >= 0) continue;
    throw InputError("part '" + names[part] +
                     "' is left without facets; draw a longer stroke for it, away from those of other parts");
  }
  return main;
}

/// The settled label with the costliest common boundary with `facets`, if any is adjacent.
std::optional<int> strongest_neighbour(const TriMesh& mesh, const std::vector<int>& facets,
                                       const std::vector<bool>& is_settled, const LabelComponents& components,
                                       const Relabelling& relabelling) {
  std::map<int, double> shared;
  for (const int f : facets) {
    for (const HalfedgeHandle h : mesh.half_edges().fh_range(FaceHandle(f))) {
      const int other = mesh.half_edges().face_handle(mesh.half_edges().opposite_halfedge_handle(h)).idx();
      if (other >= 0 && is_settled[components.of_facet[other]]) {
        shared[relabelling.labels()[other]] += relabelling.boundary_cost(h);
      }
    }
  }
  if (shared.empty()) return std::nullopt;
  return std::max_element(shared.begin(), shared.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

int merge_islands(const TriMesh& mesh, const std::vector<std::string>& names, Relabelling& relabelling) {
  const LabelComponents components = label_components(mesh, relabelling.labels());
  std::vector<bool> is_settled(components.facets.size(), false);
  for (const int main : main_components(components, relabelling, names)) is_settled[main] = true;
  std::vector<int> open;
  for (std::size_t c = 0; c < is_settled.size(); ++c) {
    if (!is_settled[c]) open.push_back(static_cast<int>(c));
  }
  const int islands = static_cast<int>(open.size());
  while (!open.empty()) {
    std::vector<std::pair<int, int>> settled;
    for (const int c : open) {
      const auto label = strongest_neighbour(mesh, components.facets[c], is_settled, components, relabelling);
      if (label) settled.emplace_back(c, *label);
    }
    if (settled.empty()) throw ComputationError("a component of the mesh belongs to no connected part");
    for (const auto& [c, label] : settled) {
      relabelling.relabel(components.facets[c], label);
      is_settled[c] = true;
    }
    std::erase_if(open, [&](int c) { return is_settled[c]; });
  }
  return islands;
}

/// Runs of equally labelled facets around a vertex; the first run may have been split by the start: joined.
std::vector<std::vector<int>> fans(const TriMesh& mesh, const std::vector<int>& labels, int vertex) {
  const std::vector<int> around = facets_around(mesh, vertex);
  auto label = [&](int f) { return f < 0 ? kOutside : labels[f]; };
  std::vector<std::vector<int>> runs;
  for (std::size_t i = 0; i < around.size(); ++i) {
    if (i == 0 || label(around[i]) != label(around[i - 1])) runs.emplace_back();
    runs.back().push_back(around[i]);
  }
  if (runs.size() > 1 && label(around.front()) == label(around.back())) {
    runs.front().insert(runs.front().end(), runs.back().begin(), runs.back().end());
    runs.pop_back();
  }
  return runs;
}

/// Facets whose vertices lie within `rings` - 1 edges of `vertex`, ascending.
std::vector<int> ball(const TriMesh& mesh, int vertex, int rings) {
  std::set<int> vertices{vertex}, facets;
  for (int ring = 0; ring < rings; ++ring) {
    for (const int v : vertices) {
      for (const FaceHandle f : mesh.half_edges().vf_range(VertexHandle(v))) facets.insert(f.idx());
    }
    for (const int f : facets) vertices.insert(mesh.facet(f).begin(), mesh.facet(f).end());
  }
  return {facets.begin(), facets.end()};
}

/// The cheapest relabelling that lowers the number of extra fans near a pinched vertex.
std::optional<Relabelling::Move> best_move(const TriMesh& mesh, const Relabelling& relabelling, int vertex) {
  std::optional<Relabelling::Move> best;
  auto consider = [&](const std::vector<int>& facets, int label) {
    auto move = relabelling.evaluate(facets, label);
    if (move && (!best || move->cost < best->cost - 1e-9)) best = std::move(move);
  };
  const auto runs = fans(mesh, relabelling.labels(), vertex);
  std::set<int> near;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i].front() < 0) continue;
    near.insert(relabelling.labels()[runs[i].front()]);
    for (const std::size_t j : {(i + 1) % runs.size(), (i + runs.size() - 1) % runs.size()}) {
      if (runs[j].front() >= 0) consider(runs[i], relabelling.labels()[runs[j].front()]);
    }
  }
  for (int rings = 1; rings <= kLargestBall && !best; ++rings) {
    for (const int label : near) consider(ball(mesh, vertex, rings), label);
  }
  return best;
}

/// Ascending. Most vertices lie inside a part and are not looked at.
std::vector<int> pinched_vertices(const TriMesh& mesh, const std::vector<int>& labels) {
  const HalfEdges& half_edges = mesh.half_edges();
  std::vector<bool> is_at_boundary(mesh.vertex_count(), false);
  for (int e = 0; e < static_cast<int>(half_edges.n_edges()); ++e) {
    const HalfedgeHandle h = half_edges.halfedge_handle(OpenMesh::EdgeHandle(e), 0);
    const FaceHandle left = half_edges.face_handle(h), right = half_edges.opposite_face_handle(h);
    if (left.is_valid() && right.is_valid() && labels[left.idx()] == labels[right.idx()]) continue;
    is_at_boundary[half_edges.from_vertex_handle(h).idx()] = true;
    is_at_boundary[half_edges.to_vertex_handle(h).idx()] = true;
  }
  std::vector<int> pinched;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (is_at_boundary[v] && extra_fans(mesh, labels, v) > 0) pinched.push_back(v);
  }
  return pinched;
}

/// One pass over all pinched vertices, the cheapest repair first. Returns the number of moves made.
int repair_round(const TriMesh& mesh, const std::vector<int>& pinched, Relabelling& relabelling) {
  std::vector<std::pair<double, int>> order;
  for (const int v : pinched) {
    if (const auto move = best_move(mesh, relabelling, v)) order.emplace_back(move->cost, v);
  }
  std::sort(order.begin(), order.end());
  int moves = 0;
  for (const auto& [cost, v] : order) {
    if (extra_fans(mesh, relabelling.labels(), v) == 0) continue;
    if (const auto move = best_move(mesh, relabelling, v)) {  // anew: earlier moves may have changed it
      relabelling.relabel(move->facets, move->label);
      ++moves;
    }
  }
  return moves;
}

int remove_pinches(const TriMesh& mesh, Relabelling& relabelling) {
  int extra = 0;
  std::vector<int> pinched = pinched_vertices(mesh, relabelling.labels());
  for (const int v : pinched) extra += extra_fans(mesh, relabelling.labels(), v);
  while (!pinched.empty()) {
    if (repair_round(mesh, pinched, relabelling) == 0) {
      throw ComputationError("the part boundaries touch themselves at vertex " +
                             std::to_string(pinched.front()) +
                             " and no small change avoids it; draw more strokes around this vertex");
    }
    pinched = pinched_vertices(mesh, relabelling.labels());
  }
  return extra;
}

}  // namespace

RepairedLabels repair_labels(const TriMesh& mesh, const std::vector<std::string>& names, const Seeds& seeds,
                             std::vector<int> labels, const std::vector<double>& boundary_costs) {
  const std::vector<int> given = labels;
  Relabelling relabelling(mesh, seeds, std::move(labels), boundary_costs);
  RepairedLabels result;
  result.merged_islands = merge_islands(mesh, names, relabelling);
  result.removed_pinches = remove_pinches(mesh, relabelling);
  result.labels = relabelling.labels();
  for (std::size_t f = 0; f < given.size(); ++f) result.changed_facets += given[f] != result.labels[f];
  return result;
}

}  // namespace partwise
