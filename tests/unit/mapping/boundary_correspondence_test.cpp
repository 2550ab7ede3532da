#include "mapping/boundary_correspondence.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "error.h"
#include "models.h"

namespace partwise {
namespace {

using tests::octant_model;
using tests::reindexed;

Vec3 place_on(const TriMesh& target, const BoundaryPlacement& p) {
  return (1 - p.fraction) * target.point(p.target_a) + p.fraction * target.point(p.target_b);
}

/// Largest distance of the placements from where `motion` brings the source vertices, over the target's
/// diagonal.
double largest_error(const SegmentedModel& source, const SegmentedModel& target,
                     const Eigen::Affine3d& motion) {
  const ModelPair pair = pair_models(source, target);
  const BoundaryCorrespondence match = match_boundaries(pair);
  EXPECT_FALSE(match.placements.empty());
  double largest = 0;
  for (const BoundaryPlacement& p : match.placements) {
    const Vec3 expected = motion * source.mesh.point(p.source_vertex);
    largest = std::max(largest, (place_on(target.mesh, p) - expected).norm());
  }
  return largest / target.mesh.diagonal();
}

TEST(BoundaryCorrespondence, AModelFindsItself) {
  const Eigen::Affine3d still = Eigen::Affine3d::Identity();
  for (const int axes : {1, 2, 3}) {
    const SegmentedModel model = octant_model(tests::lumpy_sphere(8), axes);
    EXPECT_EQ(largest_error(model, model, still), 0) << axes;
  }
}

TEST(BoundaryCorrespondence, AMovedScaledRenumberedCopyFindsItself) {
  const Eigen::Affine3d motion = tests::some_similarity();
  for (const int axes : {1, 2, 3}) {
    SegmentedModel model = octant_model(tests::lumpy_sphere(8), axes);
    // A landmark off the axis of the two centroids, which alone leave the turn about it open.
    model.markers.push_back({"m", {0, {1, 0, 0}}});
    SegmentedModel copy = reindexed(model, motion);
    copy.markers = {{"m", {0, {1, 0, 0}}}};
    EXPECT_LT(largest_error(model, copy, motion), 1e-9) << axes;
    EXPECT_LT(largest_error(copy, model, motion.inverse()), 1e-9) << axes;
  }
}

TEST(BoundaryCorrespondence, TorusHalvesKeepTheirTwoLoopsApart) {
  SegmentedModel model = octant_model(tests::torus(3, 1, 24, 10), 1);
  Points points = model.mesh.points();
  for (Vec3& p : points) p = Vec3(p.x() * 1.3, p.y() + 0.1 * p.x() * p.x(), p.z() * (1 + 0.1 * p.y()));
  model.mesh = model.mesh.with_points(points);
  model = octant_model(model.mesh, 1);
  ASSERT_EQ(model.segmentation.curves.size(), 2U);
  EXPECT_EQ(largest_error(model, model, Eigen::Affine3d::Identity()), 0);
  // Anchors overrule the distance: they send each loop onto the other.
  SegmentedModel other = model;
  const auto& curves = model.segmentation.curves;
  model.anchors = {{"a", 0, 1, curves[0].vertices[0], 0, false},
                   {"b", 0, 1, curves[1].vertices[0], 0, false}};
  other.anchors = {{"a", 0, 1, curves[1].vertices[2], 0, false},
                   {"b", 0, 1, curves[0].vertices[3], 0, false}};
  const ModelPair pair = pair_models(model, other);
  const BoundaryCorrespondence match = match_boundaries(pair);
  EXPECT_EQ(match.curves[0].curves.target_curve, 1);
  EXPECT_EQ(match.curves[1].curves.target_curve, 0);
  for (const BoundaryPlacement& p : match.placements) {
    if (p.source_vertex == curves[0].vertices[0]) {
      EXPECT_EQ(p.target_a, curves[1].vertices[2]);
    }
  }
}

TEST(BoundaryCorrespondence, OpenMeshesAndTheirOutside) {
  const Eigen::Affine3d motion = tests::some_similarity();
  for (const int axes : {0, 1, 2}) {
    SegmentedModel model = octant_model(tests::hemisphere(8), axes);
    Points points = model.mesh.points();
    for (Vec3& p : points) p = Vec3(1.4 * p.x() + 0.2 * p.y() * p.y(), p.y(), 0.8 * p.z() - 0.1 * p.x());
    model = octant_model(model.mesh.with_points(points), axes);
    model.markers = {{"a", {0, {1, 0, 0}}}, {"b", {70, {0, 1, 0}}}, {"c", {40, {0.2, 0.3, 0.5}}}};
    EXPECT_EQ(largest_error(model, model, Eigen::Affine3d::Identity()), 0) << axes;
    const SegmentedModel copy = reindexed(model, motion);
    EXPECT_LT(largest_error(model, copy, motion), 1e-9) << axes;
  }
}

/// A flat square of n x n cells: one closed boundary of length 8, corners at multiples of 2.
SegmentedModel square(int n) {
  return octant_model(tests::grid(n), 0);
}

TEST(BoundaryCorrespondence, FractionsOfArcLengthWorkedOutByHand) {
  // The coarse square has edges of length 1 (8 vertices), the fine one of length 2/3 (12 vertices).
  SegmentedModel coarse = square(2), fine = square(3);
  coarse.anchors = {{"low", 0, kOutside, 0, 0, false}};  // both at (-1, -1)
  fine.anchors = {{"low", 0, kOutside, 0, 0, false}};
  const ModelPair pair = pair_models(coarse, fine);
  const BoundaryCorrespondence match = match_boundaries(pair);
  ASSERT_EQ(match.placements.size(), 8U);
  for (const BoundaryPlacement& p : match.placements) {
    const bool corner = coarse.mesh.point(p.source_vertex).cwiseAbs().sum() > 1.5;
    EXPECT_NEAR(p.fraction, corner ? 0 : 0.5, 1e-12);  // 1 of 2 = 1.5 of 3 edges
    EXPECT_LT((place_on(fine.mesh, p) - coarse.mesh.point(p.source_vertex)).norm(), 1e-12);
  }
}

TEST(BoundaryCorrespondence, VerticesBetweenAnchorsAreSpreadByLength) {
  SegmentedModel model = square(2), other = square(2);
  const std::vector<int> loop = model.segmentation.curves[0].vertices;
  // From the second anchor on, 2 edges of the source share 4 of the target, then 6 share 4.
  model.anchors = {{"a", 0, kOutside, loop[1], 0, false}, {"b", 0, kOutside, loop[3], 0, false}};
  other.anchors = {{"a", 0, kOutside, loop[6], 0, false}, {"b", 0, kOutside, loop[2], 0, false}};
  const BoundaryCorrespondence match = match_boundaries(pair_models(model, other));
  auto image = [&](int v) {
    const auto found = std::find_if(match.placements.begin(), match.placements.end(),
                                    [&](const BoundaryPlacement& p) { return p.source_vertex == v; });
    return place_on(other.mesh, *found);
  };
  EXPECT_LT((image(loop[1]) - other.mesh.point(loop[6])).norm(), 1e-12);
  EXPECT_LT((image(loop[2]) - other.mesh.point(loop[0])).norm(), 1e-12);
  EXPECT_LT((image(loop[3]) - other.mesh.point(loop[2])).norm(), 1e-12);
  const Vec3 third = other.mesh.point(loop[2]) / 3 + 2 * other.mesh.point(loop[3]) / 3;  // 4/6 of an edge
  EXPECT_LT((image(loop[4]) - third).norm(), 1e-12);
}

TEST(BoundaryCorrespondence, RefusesAnchorsInAnotherCyclicOrder) {
  SegmentedModel model = square(4), other = square(4);
  const std::vector<int> loop = model.segmentation.curves[0].vertices;
  for (const auto& [name, at] : {std::pair("a", 0), std::pair("b", 4), std::pair("c", 8)}) {
    model.anchors.push_back({name, 0, kOutside, loop[at], 0, false});
    other.anchors.push_back({name, 0, kOutside, loop[(16 - at) % 16], 0, false});
  }
  try {
    match_boundaries(pair_models(model, other));
    FAIL() << "accepted";
  } catch (const InputError& error) {
    const std::string text = error.what();
    for (const char* name : {"'a'", "'b'", "'c'"}) EXPECT_NE(text.find(name), std::string::npos) << text;
  }
}

TEST(BoundaryCorrespondence, RefusesOtherPartsAndOtherCurves) {
  const SegmentedModel quarters = octant_model(tests::sphere(6), 2),
                       eighths = octant_model(tests::sphere(6), 3);
  EXPECT_THROW(pair_models(quarters, eighths), InputError);
  const SegmentedModel torus = octant_model(tests::torus(3, 1, 24, 10), 1);
  const SegmentedModel ball = octant_model(tests::sphere(6), 1);
  EXPECT_THROW(match_boundaries(pair_models(torus, ball)), InputError);
}

TEST(ModelPair, NamesLandmarksOfOneModelAndOfDifferentParts) {
  SegmentedModel source = octant_model(tests::sphere(6), 1), target = source;
  int front = 0, back = 0;  // a facet of each part
  for (int f = 0; f < source.mesh.facet_count(); ++f) (source.segmentation.labels[f] ? back : front) = f;
  const Vec3 middle = Vec3::Constant(1.0 / 3);
  source.markers = {{"both", {front, middle}}, {"lost", {front, middle}}, {"moved", {front, middle}}};
  target.markers = {{"both", {front, middle}}, {"extra", {front, middle}}, {"moved", {back, middle}}};
  const ModelPair pair = pair_models(source, target);
  ASSERT_EQ(pair.warnings.size(), 3U);
  EXPECT_NE(pair.warnings[0].find("'lost' only on the source"), std::string::npos);
  EXPECT_NE(pair.warnings[1].find("'extra' only on the target"), std::string::npos);
  EXPECT_NE(pair.warnings[2].find("'p0'"), std::string::npos);
  EXPECT_NE(pair.warnings[2].find("'p1'"), std::string::npos);
  EXPECT_EQ(pair.markers.size(), 2U);
  ASSERT_EQ(pair.marker_constraints.size(), 1U);
  EXPECT_EQ(pair.marker_constraints[0].part, 0);
}

}  // namespace
}  // namespace partwise
