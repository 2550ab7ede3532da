#include "geometry/flat_sides.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "builders.h"

namespace partwise {
namespace {

std::set<Facet> rotated(const Facets& facets) {
  std::set<Facet> result;
  for (Facet f : facets) {
    std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
    result.insert(f);
  }
  return result;
}

// A prism over a regular polygon: bottom vertices 0 ... n - 1, top vertices n ... 2 n - 1. The corner from
// which every flat side is cut is `apex` steps from its first.
Facets prism(int n, int apex) {
  Facets facets;
  for (int i = 1; i + 1 < n; ++i) {
    const int a = apex % n, b = (apex + i) % n, c = (apex + i + 1) % n;
    facets.push_back({a, c, b});
    facets.push_back({n + a, n + b, n + c});
  }
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    if (apex % 2 == 0) {
      facets.insert(facets.end(), {{i, j, n + j}, {i, n + j, n + i}});
    } else {
      facets.insert(facets.end(), {{i, j, n + i}, {j, n + j, n + i}});
    }
  }
  return facets;
}

// Corners with whole coordinates, so that flat sides are flat exactly.
Points hexagonal_prism() {
  Points points;
  for (const double z : {0.0, 3.0}) {
    for (const auto& [x, y] : {std::pair{2, 0}, {4, 0}, {6, 2}, {4, 4}, {2, 4}, {0, 2}})
      points.emplace_back(x, y, z);
  }
  return points;
}

TEST(FlatSides, HaveOneTriangulationWhateverTheyHadBefore) {
  const Points points = hexagonal_prism();
  const std::set<Facet> expected = rotated(fan_flat_sides(points, prism(6, 0)));
  EXPECT_EQ(expected.size(), prism(6, 0).size());
  for (const Facet& top : {Facet{6, 7, 8}, {6, 8, 9}, {6, 9, 10}, {6, 10, 11}})
    EXPECT_TRUE(expected.contains(top));
  EXPECT_TRUE(expected.contains({0, 1, 7}));
  for (int apex = 1; apex < 6; ++apex) {
    Facets facets = prism(6, apex);
    EXPECT_EQ(rotated(fan_flat_sides(points, facets)), expected);
    std::reverse(facets.begin(), facets.end());
    EXPECT_EQ(rotated(fan_flat_sides(points, facets)), expected);
  }
}

TEST(FlatSides, OneFacetEachStayAsTheyAre) {
  const TriMesh mesh = tests::tetrahedron();
  EXPECT_EQ(rotated(fan_flat_sides(mesh.points(), mesh.facets())), rotated(mesh.facets()));
}

TEST(FlatSides, NearlyFlatSidesAreNotFlat) {
  Points points = hexagonal_prism();
  points[7].z() += 1e-13;  // a corner of the top: the facets around it leave its plane
  const Facets facets = prism(6, 3);
  const std::set<Facet> top = rotated(fan_flat_sides(points, facets));
  EXPECT_TRUE(top.contains({6, 7, 9}));
}

}  // namespace
}  // namespace partwise
