#include "deform/shape_blend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "builders.h"
#include "deform/aligned_model.h"
#include "deform/rotation_logarithms.h"
#include "error.h"
#include "measure/inverted_facets.h"
#include "mesh/part.h"
#include "point_sets.h"

namespace partwise {
namespace {

using tests::largest_distance;
using tests::mapped;

constexpr double kPi = std::numbers::pi;

double volume(const TriMesh& mesh) {
  double six_times = 0;
  for (const auto& [a, b, c] : mesh.facets()) {
    six_times += mesh.point(a).dot(mesh.point(b).cross(mesh.point(c)));
  }
  return six_times / 6;
}

/// The part of a capsule along z that lies above `lowest`, closed, at other positions.
double limb_volume(const TriMesh& capsule, double lowest, const Points& points) {
  std::vector<bool> inside;
  for (const auto& [a, b, c] : capsule.facets()) {
    inside.push_back(std::min({capsule.point(a).z(), capsule.point(b).z(), capsule.point(c).z()}) >= lowest);
  }
  return volume(extract_piece(capsule.with_points(points), inside).mesh);
}

/// Bends a bar along z by `angle` within |z| < 2, so that what lies above swings.
Points swung(const Points& points, double angle) {
  const double radius = 4 / angle;
  return mapped(points, [&](const Vec3& p) {
    const double turn = std::clamp((p.z() + 2) / 4, 0.0, 1.0) * angle;
    const Vec3 along(0, std::sin(turn), std::cos(turn)), across(0, std::cos(turn), -std::sin(turn));
    const Vec3 centre(0, radius * (1 - std::cos(turn)), radius * std::sin(turn) - 2);
    const double beyond = std::max(0.0, p.z() - 2) + std::min(0.0, p.z() + 2);
    return Vec3(centre + beyond * along + p.y() * across + Vec3(p.x(), 0, 0));
  });
}

TEST(ShapeBlend, AModelAloneIsThatModel) {
  const TriMesh first = tests::bumpy_sphere(8, 0.3);
  const Points second = mapped(first.points(), [](const Vec3& p) {
    return Vec3(2 * p.x() + std::sin(p.y()), -p.z(), p.y() + 0.3 * p.x() * p.x());
  });
  const Points third = tests::sphere(8).points();
  const ShapeBlend blend(first, {second, third});
  const auto frames = blend.frames({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  EXPECT_LT(largest_distance(frames[0], first.points()), 1e-12);
  EXPECT_LT(largest_distance(frames[1], second), 1e-12);
  EXPECT_LT(largest_distance(frames[2], third), 1e-12);
}

TEST(ShapeBlend, RigidMotionsStayRigid) {
  const TriMesh first = tests::bumpy_sphere(6, 0.3);
  const Vec3 turn = 3.0 * Vec3(2, -1, 2) / 3;
  const auto moved = [&](double t) {
    return mapped(first.points(), [&](const Vec3& p) {
      return Vec3(rotation_exponential(t * turn) * p + t * Vec3(5, 6, 7));
    });
  };
  const ShapeBlend blend(first, {moved(1)});
  const auto frames = blend.frames({{0.75, 0.25}, {0.5, 0.5}, {-0.5, 1.5}});
  EXPECT_LT(largest_distance(frames[0], moved(0.25)), 1e-9);
  EXPECT_LT(largest_distance(frames[1], moved(0.5)), 1e-9);
  EXPECT_LT(largest_distance(frames[2], moved(1.5)), 1e-9);
}

TEST(ShapeBlend, ASwungLimbKeepsItsVolume) {
  const TriMesh rest = tests::capsule(16, 24, 64);
  const Points end = swung(rest.points(), kPi / 2);
  const double before = limb_volume(rest, 2, rest.points());
  const Points turned = ShapeBlend(rest, {end}).frames({{0.5, 0.5}})[0];
  const Points straight = ShapeBlend(rest, {end}, BlendMethod::linear).frames({{0.5, 0.5}})[0];
  EXPECT_NEAR(limb_volume(rest, 2, turned) / before, 1, 0.01);
  EXPECT_NEAR(volume(rest.with_points(turned)) / volume(rest), 1, 0.01);
  EXPECT_LT(limb_volume(rest, 2, straight) / before, 0.7);
}

TEST(ShapeBlend, TwistsOfMoreThanHalfATurnComeBackTheWayTheyWent) {
  const TriMesh rest = tests::capsule(30, 12, 120);
  const auto twisted = [&](double most) {
    return mapped(rest.points(), [&](const Vec3& p) {
      return Vec3(rotation_exponential(most * std::clamp(p.z() / 30 + 0.5, 0.0, 1.0) * Vec3::UnitZ()) * p);
    });
  };
  const Points half = ShapeBlend(rest, {twisted(5)}).frames({{0.5, 0.5}})[0];
  // Not exact, for the end is a bit stretched; one turn more or less would be far off.
  const Points expected = twisted(2.5);
  double error = 0;
  for (std::size_t v = 0; v < half.size(); ++v) {
    error = std::max(error, std::abs(half[v].head<2>().norm() - expected[v].head<2>().norm()));
  }
  EXPECT_LT(error, 0.05);
  EXPECT_NEAR(volume(rest.with_points(half)) / volume(rest), 1, 0.02);
  EXPECT_TRUE(inverted_facets(half, rest.facets()).empty());
}

TEST(ShapeBlend, FollowsSimilarities) {
  const TriMesh first = tests::capsule(16, 12, 32);
  const Points second = swung(first.points(), 1);
  const Eigen::Matrix3d turn = rotation_exponential(Vec3(1, 2, 3));
  const auto moved = [&](const Points& points) {
    return mapped(points, [&](const Vec3& p) { return Vec3(1e3 * (turn * p + Vec3(4, 5, 6))); });
  };
  const Points plain = ShapeBlend(first, {second}).frames({{0.3, 0.7}})[0];
  const Points after =
      ShapeBlend(first.with_points(moved(first.points())), {moved(second)}).frames({{0.3, 0.7}})[0];
  EXPECT_LT(largest_distance(after, moved(plain)), 1e-7);
}

TEST(ShapeBlend, ComponentsGoTheirOwnWays) {
  const TriMesh first = tests::two_spheres(4);
  const auto moved = [&](double t) {
    return mapped(first.points(), [&](const Vec3& p) {
      return p.x() > 2.5
                 ? Vec3(rotation_exponential(t * Vec3(0, 0, 1)) * (p - Vec3(5, 0, 0)) + Vec3(5, 2 * t, 0))
                 : p;
    });
  };
  const Points half = ShapeBlend(first, {moved(1)}).frames({{0.5, 0.5}})[0];
  EXPECT_LT(largest_distance(half, moved(0.5)), 1e-9);
}

TEST(ShapeBlend, FacetsWithoutAreaDoNoHarm) {
  const TriMesh first = tests::sphere(6);
  Points second = first.points();
  const Facet flat = first.facet(40);
  second[flat[0]] = 0.5 * (second[flat[1]] + second[flat[2]]);
  const auto frames = ShapeBlend(first, {second}).frames({{1, 0}, {0.5, 0.5}, {0, 1}});
  EXPECT_LT(largest_distance(frames[0], first.points()), 1e-12);
  EXPECT_LT(largest_distance(frames[2], second), 1e-12);
  EXPECT_LT(largest_distance(frames[1], first.points()), 0.2);
  const auto back = ShapeBlend(first.with_points(second), {first.points()}).frames({{0, 1}});
  EXPECT_LT(largest_distance(back[0], first.points()), 1e-12);
}

TEST(ShapeBlend, SumsOtherThanOneScale) {
  const TriMesh first = tests::bumpy_sphere(5, 0.2);
  const Points second = tests::sphere(5).points();
  for (const BlendMethod method : {BlendMethod::rotations, BlendMethod::linear}) {
    const auto frames = ShapeBlend(first, {second}, method).frames({{0.5, 0.5}, {1, 1}});
    EXPECT_LT(largest_distance(frames[1], mapped(frames[0], [](const Vec3& p) { return Vec3(2 * p); })),
              1e-12);
  }
}

TEST(ShapeBlend, BeyondTheEndsNothingTurnsInsideOut) {
  const TriMesh first = tests::sphere(6);
  const Points second = mapped(first.points(), [](const Vec3& p) { return Vec3(p.x(), p.y(), 0.3 * p.z()); });
  const auto beyond = ShapeBlend(first, {second}).frames({{-0.3, 1.3}, {1.5, -0.5}});
  for (const Points& points : beyond) EXPECT_TRUE(inverted_facets(points, first.facets()).empty());
}

TEST(ShapeBlend, RefusesWhatDoesNotFit) {
  const TriMesh first = tests::sphere(3);
  EXPECT_THROW(ShapeBlend(first, {tests::sphere(4).points()}), InputError);
  EXPECT_THROW(ShapeBlend(first, {first.points()}).frames({{1, 0, 0}}), InputError);
}

TEST(ShapeBlend, AnyNumberOfFramesIsTheSameOneByOne) {
  const TriMesh first = tests::bumpy_sphere(4, 0.2);
  const ShapeBlend blend(first, {tests::sphere(4).points()});
  const auto weights = weights_along(2, 70);
  const auto together = blend.frames(weights);
  EXPECT_EQ(together[50], blend.frames({weights[50]})[0]);
}

TEST(AlignedModel, UndoesASimilarity) {
  const TriMesh first = tests::bumpy_sphere(5, 0.3);
  const Points moved = mapped(first.points(), [](const Vec3& p) {
    return Vec3(7 * (rotation_exponential(Vec3(1, 2, -1)) * p) + Vec3(3, 0, 9));
  });
  EXPECT_LT(largest_distance(aligned_model(moved, first.points(), first.facets()), first.points()), 1e-12);
  EXPECT_NEAR(surface_area(moved, first.facets()), 49 * surface_area(first.points(), first.facets()), 1e-9);
}

TEST(WeightsAlong, PassThroughEveryModel) {
  const auto rows = weights_along(3, 5);
  EXPECT_EQ(rows.front(), (std::vector<double>{1, 0, 0}));
  EXPECT_EQ(rows[1], (std::vector<double>{0.5, 0.5, 0}));
  EXPECT_EQ(rows[2], (std::vector<double>{0, 1, 0}));
  EXPECT_EQ(rows.back(), (std::vector<double>{0, 0, 1}));
  EXPECT_EQ(weights_at(2, 1.5), (std::vector<double>{-0.5, 1.5}));
}

}  // namespace
}  // namespace partwise
