#include "geometry/facet_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace partwise {
namespace {

constexpr double kMostCells = 256;  // along the diagonal

template <typename Visit>
void for_each_cell(const std::array<int, 3>& first, const std::array<int, 3>& last, const Visit& visit) {
  for (int x = first[0]; x <= last[0]; ++x) {
    for (int y = first[1]; y <= last[1]; ++y) {
      for (int z = first[2]; z <= last[2]; ++z) visit({x, y, z});
    }
  }
}

}  // namespace

FacetGrid::FacetGrid(const Points& points, const Facets& facets) {
  Vec3 low = points[facets[0][0]], high = low;
  double edges = 0;
  for (const auto& [a, b, c] : facets) {
    for (const int v : {a, b, c}) {
      low = low.cwiseMin(points[v]);
      high = high.cwiseMax(points[v]);
    }
    edges += (points[b] - points[a]).norm();
  }
  origin_ = low;
  cell_size_ = std::max({1.5 * edges / static_cast<double>(facets.size()), (high - low).norm() / kMostCells,
                         std::numeric_limits<double>::min()});
  ranges_.reserve(facets.size());
  for (std::size_t f = 0; f < facets.size(); ++f) {
    ranges_.push_back(range(points, facets[f]));
    for_each_cell(ranges_[f].first, ranges_[f].last,
                  [&](const Cell& cell) { cells_[key(cell)].push_back(static_cast<int>(f)); });
  }
}

void FacetGrid::update(int facet, const Points& points, const Facet& corners) {
  const Range now = range(points, corners);
  Range& noted = ranges_[facet];
  if (now.first == noted.first && now.last == noted.last) return;
  for_each_cell(noted.first, noted.last, [&](const Cell& cell) { std::erase(cells_[key(cell)], facet); });
  for_each_cell(now.first, now.last, [&](const Cell& cell) { cells_[key(cell)].push_back(facet); });
  noted = now;
}

std::vector<int> FacetGrid::near(const Points& points, const Facet& corners) const {
  std::vector<int> found;
  const auto [first, last] = range(points, corners);
  for_each_cell(first, last, [&](const Cell& cell) {
    const auto in_cell = cells_.find(key(cell));
    if (in_cell != cells_.end()) found.insert(found.end(), in_cell->second.begin(), in_cell->second.end());
  });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

FacetGrid::Range FacetGrid::range(const Points& points, const Facet& corners) const {
  const Vec3 &a = points[corners[0]], &b = points[corners[1]], &c = points[corners[2]];
  const Vec3 low = (a.cwiseMin(b).cwiseMin(c) - origin_) / cell_size_;
  const Vec3 high = (a.cwiseMax(b).cwiseMax(c) - origin_) / cell_size_;
  Range result;
  for (int i = 0; i < 3; ++i) {
    result.first[i] = static_cast<int>(std::floor(low[i]));
    result.last[i] = static_cast<int>(std::floor(high[i]));
  }
  return result;
}

std::uint64_t FacetGrid::key(const Cell& cell) {
  std::uint64_t result = 0;
  for (const int i : cell) result = (result << 21U) | (static_cast<std::uint64_t>(i) & 0x1fffffU);
  return result;
}

}  // namespace partwise
