#include "report/view.h"

#include <gtest/gtest.h>

#include "error.h"

namespace partwise::report {
namespace {

// A table: legs at the four corners of the ground, a slab on top that is smaller than the ground they span.
Points table(const Vec3& along, const Vec3& up, const Vec3& across) {
  Points points;
  for (const double a : {-3.0, 3.0}) {
    for (const double c : {-1.0, 1.0}) {
      points.push_back(a * along + c * across);
      points.push_back(0.5 * a * along + 2.5 * up + 0.5 * c * across);
    }
  }
  return points;
}

TEST(View, AxesAreOrthonormalAndRightHanded) {
  const View view = view_from(Vec3(1, 2, 3), Vec3(0, 0, 5));
  EXPECT_NEAR(view.right.cross(view.up).dot(view.toward), 1, 1e-12);
  EXPECT_NEAR(view.toward.dot(Vec3(1, 2, 3).normalized()), 1, 1e-12);
  EXPECT_GT(view.up.z(), 0);
  EXPECT_NEAR(view.right.z(), 0, 1e-12);
}

TEST(View, RefusesParallelDirections) {
  EXPECT_THROW(view_from(Vec3(0, 0, 1), Vec3(0, 0, -2)), InputError);
  EXPECT_THROW(view_from(Vec3(0, 0, 0), Vec3(0, 0, 1)), InputError);
}

TEST(View, ParsesSixNumbers) {
  const View view = parse_view("1,0,0,0,0.5,0");
  EXPECT_NEAR((view.toward - Vec3::UnitX()).norm(), 0, 1e-12);
  EXPECT_NEAR((view.up - Vec3::UnitY()).norm(), 0, 1e-12);
  EXPECT_THROW(parse_view("1,0,0"), UsageError);
  EXPECT_THROW(parse_view("1 0 0 0 1 0"), UsageError);
  EXPECT_THROW(parse_view("side"), UsageError);
  EXPECT_THROW(parse_view("1,0,0,0,1,0,7"), UsageError);
}

TEST(View, StandsBodiesOnTheirFeet) {
  const Vec3 x = Vec3::UnitX();
  const Vec3 y = Vec3::UnitY();
  const Vec3 z = Vec3::UnitZ();
  for (const auto& [along, up, across] : {std::array{x, y, z}, {x, -y, z}, {y, z, x}, {z, -x, y}}) {
    const View view = automatic_view(table(along, up, across));
    EXPECT_GT(view.up.dot(up), 0.9);
    EXPECT_NEAR(view.right.dot(up), 0, 1e-12);
    EXPECT_GT(std::abs(view.toward.dot(across)), 0.8);
  }
}

}  // namespace
}  // namespace partwise::report
