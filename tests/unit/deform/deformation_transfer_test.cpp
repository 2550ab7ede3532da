#include "deform/deformation_transfer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "builders.h"
#include "convex_pairs.h"
#include "deform/rotation_logarithms.h"
#include "error.h"
#include "measure/inverted_facets.h"
#include "point_sets.h"
#include "remeshing/reconstruct.h"

namespace partwise {
namespace {

using tests::largest_distance;
using tests::mapped;

FacetCorrespondence identical(const TriMesh& mesh) {
  FacetCorrespondence correspondence;
  for (int f = 0; f < mesh.facet_count(); ++f) correspondence.push_back({{f, 1.0}});
  return correspondence;
}

CompatibleMesh pair(const TriMesh& source, const TriMesh& target) {
  return reconstruct(tests::projected_pair(tests::halves(source), tests::halves(target))).mesh;
}

/// A bend of everything about the x axis; y is the normal of the neutral plane.
Points bent(const Points& points, double curvature) {
  return mapped(points, [&](const Vec3& p) {
    const double angle = curvature * p.z(), radius = 1 / curvature;
    return Vec3(p.x(), radius - (radius - p.y()) * std::cos(angle), (radius - p.y()) * std::sin(angle));
  });
}

TEST(DeformationTransfer, ToItselfIsThePose) {
  const TriMesh mesh = tests::bumpy_sphere(6, 0.3);
  const Points pose = mapped(mesh.points(), [](const Vec3& p) {
    return Vec3(p.x() + 3, 1.5 * p.y() + std::sin(p.z()), p.z() + 0.2 * p.x() * p.y());
  });
  const Points second = bent(mesh.points(), 0.4);
  const auto followed = DeformationTransfer(mesh, mesh, identical(mesh)).follow({pose, second});
  EXPECT_LT(largest_distance(followed[0], pose), 1e-12);
  EXPECT_LT(largest_distance(followed[1], second), 1e-12);
}

TEST(DeformationTransfer, TheFollowerDeformsAsTheLeader) {
  const TriMesh leader = tests::sphere(12), follower = tests::bumpy_sphere(8, 0.2);
  const CompatibleMesh map = pair(leader, follower);
  const TwoWayMap both(map);
  ASSERT_TRUE(both.one_to_one());
  const auto correspondence = exact_correspondence(sample_origins(map, both, Direction::to_target));
  const DeformationTransfer transfer(leader, follower, correspondence);
  const auto followed = transfer.follow({bent(leader.points(), 0.5)});
  EXPECT_TRUE(inverted_facets(followed[0], follower.facets()).empty());
  // What the bend does to the follower itself, but for where that lies.
  const Points expected = bent(follower.points(), 0.5);
  Vec3 offset = Vec3::Zero();
  for (std::size_t v = 0; v < expected.size(); ++v)
    offset += (expected[v] - followed[0][v]) / expected.size();
  EXPECT_LT(largest_distance(mapped(followed[0], [&](const Vec3& p) { return Vec3(p + offset); }), expected),
            0.2);
}

TEST(DeformationTransfer, RigidPosesAreFollowedRigidlyAtTheFollowersScale) {
  const TriMesh leader = tests::sphere(6);
  const TriMesh follower = leader.with_points(mapped(
      tests::bumpy_sphere(6, 0.3).points(), [](const Vec3& p) { return Vec3(10 * p + Vec3(50, 0, 0)); }));
  const Eigen::Matrix3d turn = rotation_exponential(Vec3(0, 2, 1));
  const Points pose = mapped(leader.points(), [&](const Vec3& p) { return Vec3(turn * p + Vec3(0, 1, 0)); });
  const auto followed = DeformationTransfer(leader, follower, identical(leader)).follow({pose});
  const double scale = follower.diagonal() / leader.diagonal();
  const Points expected = mapped(follower.points(), [&](const Vec3& p) {
    return Vec3(turn * (p - Vec3(50, 0, 0)) + Vec3(50, scale, 0));
  });
  EXPECT_LT(largest_distance(followed[0], expected), 1e-9);
}

TEST(DeformationTransfer, WhatGrowsMakesGrowWhateverTheFacetsDirections) {
  const TriMesh leader = tests::cube(6), follower = tests::bumpy_sphere(9, 0.2);
  const CompatibleMesh map = pair(leader, follower);
  const auto correspondence = exact_correspondence(sample_origins(map, TwoWayMap(map), Direction::to_target));
  const auto twice = [](const Points& points) {
    return mapped(points, [](const Vec3& p) { return Vec3(2 * p); });
  };
  const auto followed =
      DeformationTransfer(leader, follower, correspondence).follow({twice(leader.points())});
  Vec3 offset = Vec3::Zero();
  const Points expected = twice(follower.points());
  for (std::size_t v = 0; v < expected.size(); ++v)
    offset += (expected[v] - followed[0][v]) / expected.size();
  EXPECT_LT(largest_distance(mapped(followed[0], [&](const Vec3& p) { return Vec3(p + offset); }), expected),
            1e-9);
}

TEST(DeformationTransfer, TurnedModelsAreNoticedAndServed) {
  const TriMesh leader = tests::capsule(6, 12, 12);
  const Eigen::Matrix3d turn = rotation_exponential(Vec3(std::numbers::pi / 2, 0, 0));
  const auto turned = [&](const Points& points) {
    return mapped(points, [&](const Vec3& p) { return Vec3(turn * p); });
  };
  const TriMesh follower = leader.with_points(turned(leader.points()));
  const Points pose = bent(leader.points(), 0.1);
  const DeformationTransfer transfer(leader, follower, identical(leader), {.turn = true});
  EXPECT_NEAR(transfer.turned_by(), 90, 1e-6);
  EXPECT_LT(largest_distance(transfer.follow({pose})[0], turned(pose)), 1e-9);
}

TEST(DeformationTransfer, HeldPlacesMoveAsTheirPartnersAndLeaveTheRestInShape) {
  const TriMesh leader = tests::capsule(6, 12, 24);
  const TriMesh follower = leader.with_points(
      mapped(leader.points(), [](const Vec3& p) { return Vec3(4 * p.x(), 4 * p.y(), 3 * p.z()); }));
  const Points pose = bent(leader.points(), 0.35);
  const auto extreme = [&](bool top) {
    const auto less = [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); };
    const auto& points = leader.points();
    const auto found = top ? std::max_element(points.begin(), points.end(), less)
                           : std::min_element(points.begin(), points.end(), less);
    return static_cast<int>(found - points.begin());
  };
  const int top = extreme(true), bottom = extreme(false);
  const double scale = follower.diagonal() / leader.diagonal();
  const auto held = [&](const std::vector<int>& vertices) {
    DeformationTransferOptions options;
    for (const int v : vertices) options.held.push_back({vertex_point(leader, v), vertex_point(follower, v)});
    return DeformationTransfer(leader, follower, identical(leader), options).follow({pose})[0];
  };
  const Points free = held({}), one = held({bottom}), both = held({bottom, top});
  const auto expect_held = [&](const Points& points, int v) {
    EXPECT_LT((points[v] - follower.point(v) - scale * (pose[v] - leader.point(v))).norm(), 1e-9);
  };
  expect_held(one, bottom);
  EXPECT_GT((free[bottom] - one[bottom]).norm(), 0.1);
  const Vec3 move = one[0] - free[0];  // one place alone only moves the model
  EXPECT_LT(largest_distance(mapped(free, [&](const Vec3& p) { return Vec3(p + move); }), one), 1e-9);
  expect_held(both, bottom);
  expect_held(both, top);
  EXPECT_TRUE(inverted_facets(both, follower.facets()).empty());
  const Vec3 gap = (both[top] - free[top]) - (both[bottom] - free[bottom]);
  ASSERT_GT(gap.norm(), 0.1);
  for (const Facet& facet : follower.facets()) {  // no spike: what is corrected spreads over the whole length
    for (int i = 0; i < 3; ++i) {
      const int a = facet[i], b = facet[(i + 1) % 3];
      const double change = ((both[a] - free[a]) - (both[b] - free[b])).norm();
      EXPECT_LT(change, 0.25 * gap.norm());
    }
  }
}

TEST(DeformationTransfer, ThePlacesToHoldMustDiffer) {
  const TriMesh mesh = tests::sphere(4);
  const HeldPair pair{vertex_point(mesh, 5), vertex_point(mesh, 5)};
  EXPECT_THROW(DeformationTransfer(mesh, mesh, identical(mesh), {.turn = false, .held = {pair, pair}}),
               InputError);
}

TEST(DeformationTransfer, FacetsWithoutAreaInAPoseDoNoHarm) {
  const TriMesh mesh = tests::sphere(6);
  Points pose = mesh.points();
  const Facet flat = mesh.facet(40);
  pose[flat[0]] = 0.5 * (pose[flat[1]] + pose[flat[2]]);
  const auto followed = DeformationTransfer(mesh, mesh, identical(mesh)).follow({pose});
  EXPECT_LT(largest_distance(followed[0], pose), 0.3);
}

TEST(DeformationTransfer, RefusesAPoseOfAnotherMesh) {
  const TriMesh mesh = tests::sphere(3);
  EXPECT_THROW(DeformationTransfer(mesh, mesh, identical(mesh)).follow({tests::sphere(4).points()}),
               InputError);
}

TEST(FacetCorrespondence, ExactSharesAddUpAndAreNear) {
  const CompatibleMesh map = pair(tests::cube(6), tests::sphere(9));
  const TwoWayMap both(map);
  for (const Direction direction : {Direction::to_target, Direction::to_source}) {
    const auto origins = sample_origins(map, both, direction);
    const auto correspondence = exact_correspondence(origins);
    ASSERT_EQ(static_cast<int>(correspondence.size()),
              direction == Direction::to_target ? map.target.facet_count() : map.source.facet_count());
    for (const auto& shares : correspondence) {
      double sum = 0;
      for (const FacetShare& share : shares) sum += share.share;
      EXPECT_NEAR(sum, 1, 1e-12);
    }
  }
}

TEST(FacetCorrespondence, OnHullsEveryFacetHasOneAndMoreWithinReach) {
  const SegmentedModel model = tests::halves(tests::sphere(8));
  const CrossMap map = tests::projected_pair(model, model);
  const auto self = hull_correspondence(map, 1e-6, Direction::to_target);
  for (int f = 0; f < model.mesh.facet_count(); ++f) {
    ASSERT_EQ(self[f].size(), 1U);
    EXPECT_EQ(self[f][0].facet, f);
  }
  const auto wide = hull_correspondence(map, 0.1, Direction::to_source);
  std::size_t pairs = 0;
  for (int f = 0; f < model.mesh.facet_count(); ++f) {
    pairs += wide[f].size();
    for (const FacetShare& share : wide[f]) {
      EXPECT_EQ(model.segmentation.labels[share.facet], model.segmentation.labels[f]);
    }
  }
  EXPECT_GT(pairs, 3U * model.mesh.facet_count());
}

}  // namespace
}  // namespace partwise
