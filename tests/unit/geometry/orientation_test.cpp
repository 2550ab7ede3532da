#include "geometry/orientation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "builders.h"

namespace partwise {
namespace {

TEST(Orientation, SignFollowsTheRightHand) {
  const Vec3 o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  EXPECT_EQ(orientation_sign(o, x, y, z), 1);
  EXPECT_EQ(orientation_sign(o, y, x, z), -1);
  EXPECT_EQ(orientation_sign(o, x, y, Vec3(0.3, -7, 0)), 0);
}

TEST(Orientation, OutwardFacetsArePositiveFromInside) {
  const TriMesh sphere = tests::sphere(6);
  for (const auto& [a, b, c] : sphere.facets()) {
    EXPECT_EQ(orientation_sign(Vec3::Zero(), sphere.point(a), sphere.point(b), sphere.point(c)), 1);
  }
}

TEST(Orientation, SeesTheSmallestStepOffAPlane) {
  // The rounded determinant cannot tell these from coplanar: the step is the last bit of a coordinate.
  const Vec3 a(12, 12, 12), b(24, 24, 24.5), c(0.5, 0.5, 0.5);
  const Vec3 on_plane(17, 17, 3);
  const Vec3 beside(17, std::nextafter(17.0, 18.0), 3);
  EXPECT_EQ(orientation_sign(a, b, c, on_plane), 0);
  EXPECT_NE(orientation_sign(a, b, c, beside), 0);
  EXPECT_EQ(orientation_sign(a, b, c, beside), -orientation_sign(b, a, c, beside));
}

}  // namespace
}  // namespace partwise
