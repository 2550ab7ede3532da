#include "geometry/point_grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace partwise {
namespace {

constexpr int kBits = 21;                        // of a key, per axis
constexpr double kMostCells = (1 << kBits) - 4;  // along an axis, with a margin for the neighbours

}  // namespace

PointGrid::PointGrid(const Points& points, double radius)
    : points_(points), radius_(radius), origin_(Vec3::Zero()) {
  if (!points.empty()) {
    origin_ = points.front();
    for (const Vec3& p : points) origin_ = origin_.cwiseMin(p);
  }
  std::vector<std::pair<std::uint64_t, int>> sorted;
  for (std::size_t i = 0; i < points.size(); ++i) {
    sorted.emplace_back(key(cell_of(points[i])), static_cast<int>(i));
  }
  std::sort(sorted.begin(), sorted.end());
  for (const auto& [key, index] : sorted) {
    keys_.push_back(key);
    order_.push_back(index);
  }
}

PointGrid::Cell PointGrid::cell_of(const Vec3& point) const {
  Cell cell{};
  for (int i = 0; i < 3; ++i) {
    // Cells far outside share one: they hold the same points, or none.
    cell[i] = static_cast<int>(std::clamp(std::floor((point[i] - origin_[i]) / radius_), -1.0, kMostCells));
  }
  return cell;
}

std::uint64_t PointGrid::key(const Cell& cell) {
  std::uint64_t key = 0;
  for (const int i : cell) key = (key << kBits) | static_cast<std::uint64_t>(std::max(i + 2, 0));
  return key;
}

std::array<std::size_t, 2> PointGrid::range(std::uint64_t first_key, std::uint64_t last_key) const {
  const auto first = std::lower_bound(keys_.begin(), keys_.end(), first_key);
  const auto last = std::upper_bound(first, keys_.end(), last_key);
  return {static_cast<std::size_t>(first - keys_.begin()), static_cast<std::size_t>(last - keys_.begin())};
}

}  // namespace partwise
