#include "mesh/validation.h"

#include <algorithm>
#include <cstdint>
#include <string>

namespace partwise {
namespace {

std::string numbered(const char* noun, long index) {
  return std::string(noun) + " " + std::to_string(index);
}

/// The first occurrence of one kind of defect, and how many there are.
struct Tally {
  std::string first;
  long count = 0;

  void add(const std::string& sentence) {
    if (count++ == 0) first = sentence;
  }
  void report(std::vector<std::string>& defects, const char* remedy) const {
    if (count == 0) return;
    std::string sentence = first;
    if (count > 1) sentence += " (and " + std::to_string(count - 1) + " more like it)";
    defects.push_back(sentence + ": " + remedy);
  }
};

void check_values(const Points& points, const Facets& facets, std::vector<std::string>& defects) {
  Tally not_finite, out_of_range, repeated;
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (!points[v].allFinite())
      not_finite.add(numbered("vertex", v) + " has a coordinate that is not finite");
  }
  const long n = static_cast<long>(points.size());
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const auto& [a, b, c] = facets[f];
    for (const int v : facets[f]) {
      if (v < 0 || v >= n) {
        out_of_range.add(numbered("facet", f) + " names " + numbered("vertex", v) + " but the mesh has " +
                         std::to_string(n) + " vertices");
        break;
      }
    }
    if (a == b || b == c || c == a) {
      repeated.add(numbered("facet", f) + " names " + numbered("vertex", a == b || a == c ? a : b) +
                   " twice");
    }
  }
  not_finite.report(defects, "give every vertex finite coordinates");
  out_of_range.report(defects, "indices are 0-based and below the number of vertices");
  repeated.report(defects, "remove degenerate facets (convert-mesh --drop-degenerate)");
}

struct DirectedEdge {
  std::uint64_t undirected;  // smaller vertex in the high half
  int facet;
  bool forward;  // from the smaller vertex to the larger
};

/// Edges by smaller vertex (counting sort), then larger vertex, then facet. \pre indices in range
std::vector<DirectedEdge> sorted_edges(std::size_t vertex_count, const Facets& facets) {
  std::vector<std::size_t> begin(vertex_count + 1, 0);
  for (const Facet& facet : facets) {
    for (int i = 0; i < 3; ++i) ++begin[std::min(facet[i], facet[(i + 1) % 3]) + 1];
  }
  for (std::size_t v = 0; v < vertex_count; ++v) begin[v + 1] += begin[v];
  std::vector<DirectedEdge> edges(facets.size() * 3);
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (std::size_t f = 0; f < facets.size(); ++f) {
    for (int i = 0; i < 3; ++i) {
      const auto u = static_cast<std::uint32_t>(facets[f][i]);
      const auto v = static_cast<std::uint32_t>(facets[f][(i + 1) % 3]);
      const auto [low, high] = std::minmax(u, v);
      edges[next[low]++] = {(std::uint64_t{low} << 32) | high, static_cast<int>(f), u < v};
    }
  }
  for (std::size_t v = 0; v < vertex_count; ++v) {
    std::sort(edges.begin() + static_cast<long>(begin[v]), edges.begin() + static_cast<long>(begin[v + 1]),
              [](const DirectedEdge& a, const DirectedEdge& b) {
                return a.undirected != b.undirected ? a.undirected < b.undirected : a.facet < b.facet;
              });
  }
  return edges;
}

std::string edge_name(std::uint64_t undirected) {
  return "edge (" + std::to_string(undirected >> 32) + ", " + std::to_string(undirected & 0xffffffffU) + ")";
}

void check_edges(const Facets& facets, const std::vector<DirectedEdge>& edges,
                 std::vector<std::string>& defects) {
  Tally duplicates, complex, opposite;
  auto sorted_facet = [&](int f) {
    Facet facet = facets[f];
    std::sort(facet.begin(), facet.end());
    return facet;
  };
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end].undirected == edges[i].undirected) ++end;
    // A pair of duplicate facets shares three edges; report it at the one between its two smallest vertices.
    for (std::size_t a = i; a < end; ++a) {
      for (std::size_t b = a + 1; b < end && end - i < 64; ++b) {
        const Facet facet = sorted_facet(edges[a].facet);
        const bool at_smallest = edges[i].undirected >> 32 == static_cast<std::uint64_t>(facet[0]) &&
                                 (edges[i].undirected & 0xffffffffU) == static_cast<std::uint64_t>(facet[1]);
        if (at_smallest && facet == sorted_facet(edges[b].facet)) {
          duplicates.add(numbered("facets", edges[a].facet) + " and " + std::to_string(edges[b].facet) +
                         " have the same three vertices");
        }
      }
    }
    if (end - i > 2) {
      complex.add(edge_name(edges[i].undirected) + " has " + std::to_string(end - i) + " facets, " +
                  numbered("facet", edges[i].facet) + " first");
    } else if (end - i == 2 && edges[i].forward == edges[i + 1].forward) {
      opposite.add(numbered("facets", edges[i].facet) + " and " + std::to_string(edges[i + 1].facet) +
                   " have opposite orientations along their " + edge_name(edges[i].undirected));
    }
    i = end;
  }
  duplicates.report(defects, "remove duplicate facets (convert-mesh --drop-duplicates)");
  complex.report(defects, "the mesh must be a 2-manifold: split or remove the facets at such edges");
  opposite.report(defects, "turn the facets of one side over (convert-mesh --orient)");
}

/// Counts the fans of facets at each vertex by joining facets over shared edges (union-find over corners).
void check_vertices(std::size_t vertex_count, const Facets& facets, const std::vector<DirectedEdge>& edges,
                    std::vector<std::string>& defects) {
  std::vector<int> parent(facets.size() * 3);
  for (std::size_t i = 0; i < parent.size(); ++i) parent[i] = static_cast<int>(i);
  auto root = [&](int i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  auto corner = [&](int f, std::uint32_t v) {
    int i = 0;
    while (static_cast<std::uint32_t>(facets[f][i]) != v) ++i;
    return 3 * f + i;
  };
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    if (edges[i].undirected != edges[i + 1].undirected) continue;
    for (const std::uint64_t v : {edges[i].undirected >> 32, edges[i].undirected & 0xffffffffU}) {
      parent[root(corner(edges[i].facet, static_cast<std::uint32_t>(v)))] =
          root(corner(edges[i + 1].facet, static_cast<std::uint32_t>(v)));
    }
  }
  std::vector<int> fans(vertex_count, 0);
  for (std::size_t i = 0; i < parent.size(); ++i) {
    if (root(static_cast<int>(i)) == static_cast<int>(i)) ++fans[facets[i / 3][i % 3]];
  }
  Tally pinched, unused;
  for (std::size_t v = 0; v < vertex_count; ++v) {
    if (fans[v] > 1) {
      pinched.add("the facets at " + numbered("vertex", v) + " form " + std::to_string(fans[v]) + " fans");
    } else if (fans[v] == 0) {
      unused.add(numbered("vertex", v) + " has no facet");
    }
  }
  pinched.report(defects, "the mesh must be a 2-manifold: give each fan a vertex of its own");
  unused.report(defects, "remove vertices without facets (convert-mesh --drop-unused)");
}

}  // namespace

std::vector<std::string> find_defects(const Points& points, const Facets& facets) {
  std::vector<std::string> defects;
  if (facets.empty()) return {"the mesh has no facets: give a triangle mesh"};
  check_values(points, facets, defects);
  if (!defects.empty()) return defects;
  const std::vector<DirectedEdge> edges = sorted_edges(points.size(), facets);
  check_edges(facets, edges, defects);
  if (!defects.empty()) return defects;
  check_vertices(points.size(), facets, edges, defects);
  return defects;
}

}  // namespace partwise
