#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "mesh/types.h"

namespace partwise {

/// Facets by the cells of a regular grid that their bounding boxes touch; facets may move.
class FacetGrid {
 public:
  /// \pre facets is not empty and names vertices of `points`
  FacetGrid(const Points& points, const Facets& facets);

  /// Notes where a facet is now.
  void update(int facet, const Points& points, const Facet& corners);

  /// Facets, as noted, in the cells that the box of `corners` touches; ascending, each once.
  std::vector<int> near(const Points& points, const Facet& corners) const;

 private:
  using Cell = std::array<int, 3>;
  struct Range {
    Cell first, last;
  };
  Range range(const Points& points, const Facet& corners) const;
  static std::uint64_t key(const Cell& cell);

  Vec3 origin_ = Vec3::Zero();
  double cell_size_ = 1;
  std::unordered_map<std::uint64_t, std::vector<int>> cells_;
  std::vector<Range> ranges_;  // per facet
};

}  // namespace partwise
