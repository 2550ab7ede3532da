#include "deform/rotation_logarithms.h"

#include <gtest/gtest.h>

#include <numbers>

#include "builders.h"
#include "deform/smoothed_rotations.h"

namespace partwise {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(RotationLogarithm, ExponentialUndoesIt) {
  for (const Vec3& vector : {Vec3(0, 0, 0), Vec3(1e-9, 0, 0), Vec3(0.3, -1, 2), Vec3(0, 0, kPi - 1e-9)}) {
    EXPECT_LT((rotation_logarithm(rotation_exponential(vector)) - vector).norm(), 1e-7) << vector.transpose();
  }
}

TEST(RotationLogarithm, OtherTurnsAreTheSameRotation) {
  const Vec3 axis = Vec3(1, 2, -2) / 3;
  const Vec3 found = nearest_logarithm(0.5 * axis, 6.5 * axis);
  EXPECT_LT((found - (0.5 + 2 * kPi) * axis).norm(), 1e-12);
  EXPECT_TRUE(rotation_exponential(found).isApprox(rotation_exponential(0.5 * axis)));
  EXPECT_LT((nearest_logarithm(3 * axis, -3 * axis) - (3 - 2 * kPi) * axis).norm(), 1e-12);
  EXPECT_LT((nearest_logarithm(Vec3::Zero(), 6 * axis) - 2 * kPi * axis).norm(), 1e-12);
}

TEST(RotationLogarithms, GoOnBeyondHalfATurn) {
  const TriMesh tube = tests::capsule(20, 12, 80);
  const auto angle_at = [](double z) { return 0.25 * (z + 11); };  // 0 at one end, 5.5 at the other
  std::vector<Eigen::Matrix3d> rotations;
  std::vector<double> angles;
  for (const Facet& f : tube.facets()) {
    angles.push_back(angle_at((tube.point(f[0]) + tube.point(f[1]) + tube.point(f[2])).z() / 3));
    rotations.push_back(rotation_exponential(angles.back() * Vec3::UnitZ()));
  }
  const Points found = rotation_logarithms(tube, rotations, std::vector<bool>(angles.size(), true));
  for (std::size_t f = 0; f < angles.size(); ++f) {
    EXPECT_LT((found[f] - angles[f] * Vec3::UnitZ()).norm(), 1e-9) << "facet " << f;
  }
}

TEST(RotationLogarithms, UnknownFacetsTakeTheirNeighbours) {
  const TriMesh mesh = tests::sphere(4);
  std::vector<Eigen::Matrix3d> rotations(mesh.facet_count(), rotation_exponential(Vec3(0.2, 0, 0)));
  std::vector<bool> known(mesh.facet_count(), true);
  known[17] = false;
  rotations[17] = rotation_exponential(Vec3(0, 3, 0));
  for (const Vec3& found : rotation_logarithms(mesh, rotations, known)) {
    EXPECT_LT((found - Vec3(0.2, 0, 0)).norm(), 1e-12);
  }
}

TEST(RotationLogarithms, FacetsThatAreCertainStayAsTheyAre) {
  const TriMesh mesh = tests::sphere(4);
  std::vector<Eigen::Matrix3d> rotations(mesh.facet_count(), rotation_exponential(Vec3(-0.2, 0, 0)));
  // One that is turned by more than half a turn against the others.
  rotations[17] = rotation_exponential(Vec3(3.5, 0, 0));
  const std::vector<bool> known(mesh.facet_count(), true);
  const Points found = rotation_logarithms(mesh, rotations, known, 1.0);
  for (int f = 0; f < mesh.facet_count(); ++f) {
    EXPECT_LT((found[f] - Vec3(f == 17 ? 3.5 - 2 * kPi : -0.2, 0, 0)).norm(), 1e-12);
  }
}

TEST(SmoothedRotations, EqualOnesStayAndSingleOnesFollowTheOthers) {
  const TriMesh mesh = tests::bumpy_sphere(6, 0.2);
  const Eigen::Matrix3d common = rotation_exponential(Vec3(1, -2, 0.5));
  std::vector<Eigen::Matrix3d> rotations(mesh.facet_count(), common);
  std::vector<bool> known(mesh.facet_count(), true);
  for (const auto& smooth : smoothed_rotations(mesh, rotations, known, 0.5)) {
    EXPECT_TRUE(smooth.isApprox(common, 1e-9));
  }
  rotations[20] = Eigen::Matrix3d::Identity();
  for (const auto& smooth : smoothed_rotations(mesh, rotations, known, 0.5)) {
    EXPECT_LT(rotation_logarithm(common.transpose() * smooth).norm(), 0.1);
  }
  known[20] = false;
  for (const auto& smooth : smoothed_rotations(mesh, rotations, known, 0.5)) {
    EXPECT_LT(rotation_logarithm(common.transpose() * smooth).norm(), 1e-6);
  }
}

}  // namespace
}  // namespace partwise
