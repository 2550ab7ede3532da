#include "mesh/repair.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <unordered_map>
#include <utility>

#include "error.h"
#include "mesh/tri_mesh.h"

namespace partwise {
namespace {

/// \pre `rows` are ascending
template <class T>
void keep_rows(std::vector<T>& table, const std::vector<std::size_t>& rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) table[i] = table[rows[i]];
  table.resize(rows.size());
}

/// Keeps the facets for which `keep` holds; counts the others.
template <class Keep>
Repaired filter_facets(TriangleSoup soup, Keep&& keep) {
  const std::size_t before = soup.facets.size();
  std::vector<std::size_t> kept;
  for (std::size_t f = 0; f < before; ++f) {
    if (keep(f)) kept.push_back(f);
  }
  keep_rows(soup.facets, kept);
  if (soup.texture) {
    keep_rows(soup.texture->places, kept);
    if (!soup.texture->images.empty()) keep_rows(soup.texture->images, kept);
  }
  return {std::move(soup), static_cast<long>(before - kept.size())};
}

/// Keeps the vertices for which `keep` holds and numbers facets anew. \pre all vertices of facets are kept
template <class Keep>
Repaired filter_vertices(TriangleSoup soup, Keep&& keep) {
  std::vector<int> number(soup.points.size(), -1);
  int kept = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (!keep(v)) continue;
    soup.points[kept] = soup.points[v];
    number[v] = kept++;
  }
  const long removed = static_cast<long>(number.size()) - kept;
  soup.points.resize(kept);
  for (Facet& facet : soup.facets) {
    for (int& vertex : facet) vertex = number[vertex];
  }
  return {std::move(soup), removed};
}

Facet sorted(Facet facet) {
  std::sort(facet.begin(), facet.end());
  return facet;
}

class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  int root(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(int a, int b) { parent_[std::max(root(a), root(b))] = std::min(root(a), root(b)); }

 private:
  std::vector<int> parent_;
};

/// Cells of a grid no smaller than the tolerance, with the vertices that stay.
class Grid {
 public:
  Grid(const Points& points, double reach) : points_(points), reach_(reach) {
    for (const Vec3& point : points) box_.extend(point);
    // Cells that are too small for 21 bits an axis would overflow the key.
    cell_ = std::max(reach, box_.isEmpty() ? 1.0 : box_.diagonal().norm() / 1e6);
    if (cell_ <= 0) cell_ = 1;
  }
  /// The first vertex within reach, or -1.
  int find(const Vec3& point) const {
    int found = -1;
    for (int i = 0; i < 27; ++i) {
      const Eigen::Vector3i step(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
      const auto entry = cells_.find(key(cell(point) + step));
      if (entry == cells_.end()) continue;
      for (const int vertex : entry->second) {
        const bool near = (points_[vertex] - point).norm() <= reach_;
        if (near && (found < 0 || vertex < found)) found = vertex;
      }
    }
    return found;
  }
  void add(int vertex) { cells_[key(cell(points_[vertex]))].push_back(vertex); }

 private:
  Eigen::Vector3i cell(const Vec3& point) const {
    return ((point - box_.min()) / cell_).array().floor().matrix().cast<int>();
  }
  static std::uint64_t key(const Eigen::Vector3i& cell) {
    const Eigen::Matrix<std::uint64_t, 3, 1> shifted = (cell.array() + 1).matrix().cast<std::uint64_t>();
    return shifted[0] << 42 | shifted[1] << 21 | shifted[2];
  }

  const Points& points_;
  double reach_;
  double cell_ = 1;
  Eigen::AlignedBox3d box_;
  std::unordered_map<std::uint64_t, std::vector<int>> cells_;
};

}  // namespace

void require_indices(const TriangleSoup& soup) {
  for (std::size_t f = 0; f < soup.facets.size(); ++f) {
    for (const int vertex : soup.facets[f]) {
      if (vertex < 0 || vertex >= static_cast<long>(soup.points.size())) {
        throw InputError("facet " + std::to_string(f) + " names vertex " + std::to_string(vertex) +
                         " but the mesh has " + std::to_string(soup.points.size()) +
                         " vertices: indices are 0-based and below the number of vertices");
      }
    }
  }
}

Repaired drop_degenerate(TriangleSoup soup) {
  const Facets facets = soup.facets;
  return filter_facets(std::move(soup), [&](std::size_t f) {
    const auto& [a, b, c] = facets[f];
    return a != b && b != c && c != a;
  });
}

Repaired drop_duplicates(TriangleSoup soup) {
  std::map<Facet, std::size_t> first;
  for (std::size_t f = 0; f < soup.facets.size(); ++f) first.try_emplace(sorted(soup.facets[f]), f);
  const Facets facets = soup.facets;
  return filter_facets(std::move(soup), [&](std::size_t f) { return first.at(sorted(facets[f])) == f; });
}

Repaired drop_unused(TriangleSoup soup) {
  std::vector<char> used(soup.points.size(), 0);
  for (const Facet& facet : soup.facets) {
    for (const int vertex : facet) used[vertex] = 1;
  }
  return filter_vertices(std::move(soup), [&](std::size_t v) { return used[v] != 0; });
}

Repaired merge_vertices(TriangleSoup soup, double tolerance) {
  const Points points = soup.points;
  Grid grid(points, tolerance * bounding_box_diagonal(points));
  std::vector<int> stays(points.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    const int earlier = grid.find(points[v]);
    stays[v] = earlier >= 0 ? earlier : static_cast<int>(v);
    if (earlier < 0) grid.add(static_cast<int>(v));
  }
  for (Facet& facet : soup.facets) {
    for (int& vertex : facet) vertex = stays[vertex];
  }
  return filter_vertices(std::move(soup), [&](std::size_t v) { return stays[v] == static_cast<int>(v); });
}

Repaired keep_largest_component(TriangleSoup soup) {
  Sets sets(soup.points.size());
  for (const auto& [a, b, c] : soup.facets) {
    sets.join(a, b);
    sets.join(b, c);
  }
  std::map<int, long> sizes;
  for (const Facet& facet : soup.facets) ++sizes[sets.root(facet[0])];
  const auto largest = std::max_element(sizes.begin(), sizes.end(),
                                        [](const auto& a, const auto& b) { return a.second < b.second; });
  const Facets facets = soup.facets;
  Repaired result = filter_facets(std::move(soup),
                                  [&](std::size_t f) { return sets.root(facets[f][0]) == largest->first; });
  return {drop_unused(std::move(result.soup)).soup, sizes.empty() ? 0 : static_cast<long>(sizes.size()) - 1};
}

}  // namespace partwise
