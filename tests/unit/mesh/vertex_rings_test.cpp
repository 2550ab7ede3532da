#include "mesh/vertex_rings.h"

#include <gtest/gtest.h>

#include "builders.h"

namespace partwise {
namespace {

TEST(VertexRings, GrowOverEdgesOfAGrid) {
  const TriMesh grid = tests::grid(6);
  std::vector<bool> corner(grid.vertex_count(), false);
  corner[0] = true;
  EXPECT_EQ(within_rings(grid.facets(), corner, 0), corner);
  // Every square has one diagonal, so a ring is what one step along axes and that diagonal reaches.
  for (const int rings : {1, 2, 3}) {
    const std::vector<bool> near = within_rings(grid.facets(), corner, rings);
    std::vector<bool> by_steps = corner;
    for (int i = 0; i < rings; ++i) {
      const std::vector<bool> before = by_steps;
      for (const auto e : grid.half_edges().edges()) {
        if (before[e.v0().idx()] || before[e.v1().idx()])
          by_steps[e.v0().idx()] = by_steps[e.v1().idx()] = true;
      }
    }
    EXPECT_EQ(near, by_steps);
  }
  EXPECT_EQ(within_rings(grid.facets(), corner, 100), std::vector<bool>(grid.vertex_count(), true));
}

}  // namespace
}  // namespace partwise
