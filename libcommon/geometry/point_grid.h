#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/types.h"

namespace partwise {

/// Points by the cells of a regular grid, for all neighbours within one fixed radius. Immutable after
/// construction; queries may run concurrently.
class PointGrid {
 public:
  /// `points` outlive the grid. \pre radius > 0
  PointGrid(const Points& points, double radius);

  /// Calls visit(index) for every point within the radius of `centre`, always in the same order.
  template <class Visit>
  void for_each_within(const Vec3& centre, Visit visit) const {
    const Cell middle = cell_of(centre);
    for (int x = -1; x <= 1; ++x) {
      for (int y = -1; y <= 1; ++y) {
        // Cells that differ in z alone follow one another.
        const auto [first, last] = range(key({middle[0] + x, middle[1] + y, middle[2] - 1}),
                                         key({middle[0] + x, middle[1] + y, middle[2] + 1}));
        for (std::size_t i = first; i < last; ++i) {
          if ((points_[order_[i]] - centre).squaredNorm() <= radius_ * radius_) visit(order_[i]);
        }
      }
    }
  }

 private:
  using Cell = std::array<int, 3>;
  Cell cell_of(const Vec3& point) const;
  static std::uint64_t key(const Cell& cell);
  std::array<std::size_t, 2> range(std::uint64_t first_key, std::uint64_t last_key) const;

  const Points& points_;
  double radius_;
  Vec3 origin_;
  std::vector<std::uint64_t> keys_;  // ascending
  std::vector<int> order_;           // points by ascending key, then index
};

}  // namespace partwise
