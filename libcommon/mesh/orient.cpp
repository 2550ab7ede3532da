#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "error.h"
#include "mesh/repair.h"

namespace partwise {
namespace {

/// Two facets at one edge; `opposed` when they run along it in the same direction.
struct Adjacency {
  int facet = 0;
  bool opposed = false;
};

struct Side {
  std::uint64_t edge;
  int facet;
  bool forward;
};

struct Neighbours {
  std::vector<std::vector<Adjacency>> of;
  std::vector<char> at_border;  ///< per facet: has an edge without exactly one neighbour
};

Neighbours find_neighbours(const Facets& facets) {
  std::vector<Side> sides;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    for (int i = 0; i < 3; ++i) {
      const auto u = static_cast<std::uint64_t>(facets[f][i]),
                 v = static_cast<std::uint64_t>(facets[f][(i + 1) % 3]);
      sides.push_back({std::min(u, v) << 32 | std::max(u, v), static_cast<int>(f), u < v});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.facet < b.facet;
  });
  Neighbours neighbours{std::vector<std::vector<Adjacency>>(facets.size()),
                        std::vector<char>(facets.size(), 0)};
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].edge == sides[begin].edge) ++end;
    if (end - begin == 2) {
      const Side &a = sides[begin], &b = sides[begin + 1];
      neighbours.of[a.facet].push_back({b.facet, a.forward == b.forward});
      neighbours.of[b.facet].push_back({a.facet, a.forward == b.forward});
    } else {
      for (std::size_t i = begin; i < end; ++i) neighbours.at_border[sides[i].facet] = 1;
    }
  }
  return neighbours;
}

enum class Turn : char { unknown, keep, over };

/// Facets reached from `first` over edges, with `turns` decided for them.
std::vector<int> decide_component(const Neighbours& neighbours, int first, std::vector<Turn>& turns) {
  std::vector<int> component{first};
  turns[first] = Turn::keep;
  for (std::size_t next = 0; next < component.size(); ++next) {
    const int facet = component[next];
    for (const Adjacency& neighbour : neighbours.of[facet]) {
      const bool over = (turns[facet] == Turn::over) != neighbour.opposed;
      const Turn turn = over ? Turn::over : Turn::keep;
      if (turns[neighbour.facet] == Turn::unknown) {
        turns[neighbour.facet] = turn;
        component.push_back(neighbour.facet);
      } else if (turns[neighbour.facet] != turn) {
        throw InputError("the surface at facet " + std::to_string(neighbour.facet) +
                         " has one side only (as a Moebius strip) and cannot be oriented: cut it open");
      }
    }
  }
  return component;
}

/// Six times the volume that the component encloses with its turned facets, seen from its first vertex.
double enclosed(const TriangleSoup& soup, const std::vector<int>& component, const std::vector<Turn>& turns) {
  const Vec3 origin = soup.points[soup.facets[component[0]][0]];
  double sum = 0;
  for (const int f : component) {
    const auto& [a, b, c] = soup.facets[f];
    const double volume =
        (soup.points[a] - origin).dot((soup.points[b] - origin).cross(soup.points[c] - origin));
    sum += turns[f] == Turn::over ? -volume : volume;
  }
  return sum;
}

}  // namespace

Repaired orient(TriangleSoup soup) {
  const Neighbours neighbours = find_neighbours(soup.facets);
  std::vector<Turn> turns(soup.facets.size(), Turn::unknown);
  for (std::size_t first = 0; first < soup.facets.size(); ++first) {
    if (turns[first] != Turn::unknown) continue;
    const std::vector<int> component = decide_component(neighbours, static_cast<int>(first), turns);
    const bool closed =
        std::none_of(component.begin(), component.end(), [&](int f) { return neighbours.at_border[f] != 0; });
    if (!closed || enclosed(soup, component, turns) >= 0) continue;
    for (const int f : component) turns[f] = turns[f] == Turn::over ? Turn::keep : Turn::over;
  }
  long turned = 0;
  for (std::size_t f = 0; f < soup.facets.size(); ++f) {
    if (turns[f] != Turn::over) continue;
    std::swap(soup.facets[f][1], soup.facets[f][2]);
    if (soup.texture) {
      auto& places = soup.texture->places[f];
      std::swap_ranges(places.begin() + 2, places.begin() + 4, places.begin() + 4);
    }
    ++turned;
  }
  return {std::move(soup), turned};
}

}  // namespace partwise
