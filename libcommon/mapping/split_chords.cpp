#include "mapping/split_chords.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace partwise {
namespace {

using Edge = std::array<int, 2>;

Edge sorted(int a, int b) {
  return a < b ? Edge{a, b} : Edge{b, a};
}

/// Cuts a facet by the midpoints of those of its edges that have one (-1 otherwise).
void cut(const Facet& f, const std::array<int, 3>& midpoints, Facets& facets) {
  const auto count = std::count_if(midpoints.begin(), midpoints.end(), [](int m) { return m >= 0; });
  if (count == 0) {
    facets.push_back(f);
    return;
  }
  // Turned so that edge (a, b) is split, and with two splits (b, c) is the other one.
  int turn = 0;
  while (midpoints[turn] < 0 || (count == 2 && midpoints[(turn + 1) % 3] < 0)) ++turn;
  const int a = f[turn], b = f[(turn + 1) % 3], c = f[(turn + 2) % 3];
  const int ab = midpoints[turn], bc = midpoints[(turn + 1) % 3], ca = midpoints[(turn + 2) % 3];
  if (count == 1) {
    facets.insert(facets.end(), {{a, ab, c}, {ab, b, c}});
  } else if (count == 2) {
    facets.insert(facets.end(), {{ab, b, bc}, {a, ab, c}, {ab, bc, c}});
  } else {
    facets.insert(facets.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
}

}  // namespace

SplitMesh split_chords(const TriMesh& mesh, const std::vector<bool>& fixed, const std::vector<Edge>& kept) {
  std::set<Edge> whole;
  for (const auto& [a, b] : kept) whole.insert(sorted(a, b));
  std::map<Edge, int> midpoints;
  std::vector<Edge> split_edges;
  Points points = mesh.points();
  Facets facets;
  for (const Facet& f : mesh.facets()) {
    std::array<int, 3> at{-1, -1, -1};
    for (int i = 0; i < 3; ++i) {
      const Edge edge = sorted(f[i], f[(i + 1) % 3]);
      if (!fixed[edge[0]] || !fixed[edge[1]] || whole.contains(edge)) continue;
      const auto [entry, is_new] = midpoints.try_emplace(edge, static_cast<int>(points.size()));
      if (is_new) {
        points.push_back((mesh.point(edge[0]) + mesh.point(edge[1])) / 2);
        split_edges.push_back(edge);
      }
      at[i] = entry->second;
    }
    cut(f, at, facets);
  }
  return {TriMesh(std::move(points), std::move(facets)), std::move(split_edges)};
}

}  // namespace partwise
