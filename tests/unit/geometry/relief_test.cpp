#include "geometry/relief.h"

#include <gtest/gtest.h>

#include "builders.h"

namespace partwise {
namespace {

TEST(Relief, OfASphereIsThatOfOneStepOfHeatFlow) {
  // Places on the unit sphere are eigenfunctions of the Laplacian, of eigenvalue 2.
  const TriMesh sphere = tests::sphere(24);
  const std::vector<Vec3> heights = relief(sphere);
  for (int i = 0; i < 3; ++i) {
    const double radius = 0.01 * (1 << i) * sphere.diagonal();
    const double expected = (1 - 1 / (1 + 2 * radius * radius)) / radius;
    for (const Vec3& height : heights) EXPECT_NEAR(height[i], expected, 0.15 * expected);
  }
}

TEST(Relief, IsHighOnBumpsAndTheSameMovedTurnedAndScaled) {
  const TriMesh mesh = tests::bumpy_sphere(8, 0.3);
  Points points;  // turned by a quarter, so that the box stays as large
  for (const Vec3& p : mesh.points()) points.push_back(50 * Vec3(-p.y(), p.x(), p.z()) + Vec3(3, -1, 7));
  const std::vector<Vec3> before = relief(mesh), after = relief(mesh.with_points(points));
  std::size_t highest = 0;
  for (std::size_t v = 0; v < before.size(); ++v) {
    EXPECT_LT((before[v] - after[v]).norm(), 1e-9);
    if (before[v].z() > before[highest].z()) highest = v;
  }
  EXPECT_NEAR(mesh.point(static_cast<int>(highest)).norm(), 1.3, 1e-3);  // a tip
}

}  // namespace
}  // namespace partwise
