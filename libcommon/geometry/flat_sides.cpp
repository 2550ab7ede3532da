#include "geometry/flat_sides.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "geometry/orientation.h"

namespace partwise {
namespace {

/// Facet on the left of every directed edge.
using LeftFacets = std::map<std::pair<int, int>, int>;

LeftFacets left_facets(const Facets& facets) {
  LeftFacets left;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    for (int i = 0; i < 3; ++i) left[{facets[f][i], facets[f][(i + 1) % 3]}] = static_cast<int>(f);
  }
  return left;
}

bool in_one_plane(const Points& points, const Facet& f, const Facet& g) {
  return std::all_of(g.begin(), g.end(), [&](int v) {
    return orientation_sign(points[f[0]], points[f[1]], points[f[2]], points[v]) == 0;
  });
}

int root_of(std::vector<int>& parent, int f) {
  while (parent[f] != f) f = parent[f] = parent[parent[f]];
  return f;
}

/// Per facet, a facet that stands for its flat side.
std::vector<int> flat_sides(const Points& points, const Facets& facets, const LeftFacets& left) {
  std::vector<int> parent(facets.size());
  std::iota(parent.begin(), parent.end(), 0);
  for (const auto& [edge, f] : left) {
    const int g = left.at({edge.second, edge.first});
    const int a = root_of(parent, f), b = root_of(parent, g);
    if (f < g && a != b && in_one_plane(points, facets[f], facets[g]))
      parent[std::max(a, b)] = std::min(a, b);
  }
  for (std::size_t f = 0; f < parent.size(); ++f) parent[f] = root_of(parent, static_cast<int>(f));
  return parent;
}

}  // namespace

Facets fan_flat_sides(const Points& points, const Facets& facets) {
  const LeftFacets left = left_facets(facets);
  const std::vector<int> side_of = flat_sides(points, facets, left);
  std::map<int, std::map<int, int>> outlines;  // per side: the vertex after each vertex of its outline
  for (const auto& [edge, f] : left) {
    if (side_of[left.at({edge.second, edge.first})] != side_of[f])
      outlines[side_of[f]][edge.first] = edge.second;
  }
  Facets fans;
  for (const auto& [side, next] : outlines) {
    const int apex = next.begin()->first;
    for (int v = next.at(apex); next.at(v) != apex; v = next.at(v)) fans.push_back({apex, v, next.at(v)});
  }
  return fans;
}

}  // namespace partwise
