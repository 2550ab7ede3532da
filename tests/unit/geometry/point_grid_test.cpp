#include "geometry/point_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace partwise {
namespace {

std::vector<int> within(const PointGrid& grid, const Vec3& centre) {
  std::vector<int> found;
  grid.for_each_within(centre, [&](int i) { found.push_back(i); });
  std::sort(found.begin(), found.end());
  return found;
}

TEST(PointGrid, FindsWhatLookingAtEveryPointFinds) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-1, 1);
  Points points;
  for (int i = 0; i < 500; ++i) points.emplace_back(place(random), place(random), place(random));
  constexpr double radius = 0.3;
  const PointGrid grid(points, radius);
  int found = 0;
  for (int i = 0; i < 100; ++i) {
    const Vec3 centre = 1.5 * Vec3(place(random), place(random), place(random));
    std::vector<int> expected;
    for (int p = 0; p < 500; ++p) {
      if ((points[p] - centre).norm() <= radius) expected.push_back(p);
    }
    EXPECT_EQ(within(grid, centre), expected);
    found += static_cast<int>(expected.size());
  }
  EXPECT_GT(found, 100);
}

TEST(PointGrid, FindsNothingFarAway) {
  const Points points{{0, 0, 0}, {1e9, 0, 0}};
  const PointGrid grid(points, 0.5);
  EXPECT_EQ(within(grid, {0.1, 0, 0}), std::vector<int>{0});
  EXPECT_EQ(within(grid, {1e9, 0.1, 0}), std::vector<int>{1});
  EXPECT_TRUE(within(grid, {-1e12, 0, 0}).empty());
}

}  // namespace
}  // namespace partwise
