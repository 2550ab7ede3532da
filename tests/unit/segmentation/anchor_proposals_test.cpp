#include "segmentation/anchor_proposals.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "builders.h"
#include "mapping/model_pair.h"
#include "segmentation/compatibility.h"
#include "segmentation/mirrored_anchors.h"
#include "segmentation/segment_mesh.h"
#include "segmentation/sketches.h"

namespace partwise {
namespace {

using tests::part_at;
using tests::vertex_near;

/// A capsule along z, cut across its waist: one closed boundary.
SegmentedModel capsule_in_halves(const Sketch& landmarks, bool proposes) {
  const TriMesh capsule = tests::capsule(4, 24, 45);
  Sketch sketch = landmarks;
  sketch.parts = {part_at(capsule, "south", {{0, 0, -3}, {1, 0, -1}}),
                  part_at(capsule, "north", {{0, 0, 3}, {1, 0, 1}})};
  SegmentationOptions options;
  options.propose_anchors = proposes;
  return segment_mesh(capsule, sketch, options).model;
}

Sketch with_marker(const Vec3& place) {
  Sketch sketch;
  sketch.markers = {{"navel", vertex_near(tests::capsule(4, 24, 45), place)}};
  return sketch;
}

TEST(AnchorProposals, LieNearAMarkerBesideTheCurveAndOppositeToIt) {
  const SegmentedModel model = capsule_in_halves(with_marker({0, 1, 0.4}), true);
  ASSERT_EQ(model.anchors.size(), 2U);
  const Anchor& first = model.anchors[0];
  const Anchor& second = model.anchors[1];
  EXPECT_EQ(first.name, "north-south near navel (proposed)");
  EXPECT_EQ(second.name, "north-south away from navel (proposed)");
  EXPECT_TRUE(first.proposed && second.proposed);
  const auto& curve = model.segmentation.curves[0].vertices;
  EXPECT_EQ(std::count(curve.begin(), curve.end(), first.vertex), 1);
  for (const int v : curve) {
    EXPECT_GE(model.mesh.point(first.vertex).y(), model.mesh.point(v).y() - 1e-9);
    EXPECT_LE(model.mesh.point(second.vertex).y(), model.mesh.point(v).y() + 1e-9);
  }
}

TEST(AnchorProposals, AreMadeOnRequestOnlyAndNeverWithoutGround) {
  EXPECT_TRUE(capsule_in_halves(with_marker({0, 1, 0.4}), false).anchors.empty());
  // The pole lies far from the curve, and there is no third part to look towards.
  EXPECT_TRUE(capsule_in_halves(with_marker({0, 0, 3}), true).anchors.empty());
}

TEST(AnchorProposals, LookTowardsAnotherPartWhereNoMarkerIsNear) {
  const TriMesh ball = tests::sphere(12);
  Sketch sketch;
  sketch.parts = {part_at(ball, "nose", {{1, 0, 0}}), part_at(ball, "tail", {{0, 1, 0}}),
                  part_at(ball, "body", {{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}, {0.7, 0.7, 0}})};
  SegmentationOptions options;
  options.propose_anchors = true;
  const SegmentedModel model = segment_mesh(ball, sketch, options).model;
  ASSERT_EQ(model.segmentation.curves.size(), 2U);
  ASSERT_EQ(model.anchors.size(), 4U);
  EXPECT_EQ(model.anchors[0].name, "body-nose towards tail (proposed)");
  EXPECT_EQ(model.anchors[1].name, "body-nose away from tail (proposed)");
  EXPECT_EQ(model.anchors[2].name, "body-tail towards nose (proposed)");
  EXPECT_GT(model.mesh.point(model.anchors[0].vertex).y(), 0.05);
  EXPECT_LT(model.mesh.point(model.anchors[1].vertex).y(), -0.05);
  EXPECT_GT(model.mesh.point(model.anchors[2].vertex).x(), 0.05);
}

TEST(MirroredName, ExchangesWholeWordsOnly) {
  EXPECT_EQ(mirrored_name("left arm"), "right arm");
  EXPECT_EQ(mirrored_name("arm-Right outer"), "arm-Left outer");
  EXPECT_FALSE(mirrored_name("cleft"));
  EXPECT_FALSE(mirrored_name("bright"));
  EXPECT_FALSE(mirrored_name("head"));
}

TEST(AnchorProposals, MirrorThoseOfTheOtherSide) {
  const TriMesh ball = tests::sphere(12);
  Sketch sketch;
  sketch.parts = {part_at(ball, "left ear", {{1, 0, 0}}), part_at(ball, "right ear", {{-1, 0, 0}}),
                  part_at(ball, "body", {{0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}})};
  SegmentationOptions options;
  options.propose_anchors = true;
  const SegmentedModel bare = segment_mesh(ball, sketch, options).model;
  const std::vector<int>& left = bare.segmentation.curves[0].vertices;
  const int top = *std::max_element(left.begin(), left.end(), [&](int a, int b) {
    return ball.point(a).dot(Vec3(0, 1, 2)) < ball.point(b).dot(Vec3(0, 1, 2));
  });
  sketch.anchors = {{"left ear top", {"left ear", "body"}, top}, {"nameless", {"left ear", "body"}, left[0]}};
  const SegmentedModel model = segment_mesh(ball, sketch, options).model;
  ASSERT_EQ(model.anchors.size(), 3U);
  const Anchor& mirrored = model.anchors[2];
  EXPECT_EQ(mirrored.name, "right ear top (proposed)");
  EXPECT_TRUE(mirrored.proposed);
  const Vec3& place = ball.point(top);
  EXPECT_LT((ball.point(mirrored.vertex) - Vec3(-place.x(), place.y(), place.z())).norm(), 0.15);
  sketch.anchors.push_back(
      {"right ear top", {"right ear", "body"}, model.segmentation.curves[1].vertices[0]});
  const SegmentedModel both = segment_mesh(ball, sketch, options).model;
  EXPECT_TRUE(std::none_of(both.anchors.begin(), both.anchors.end(),
                           [](const Anchor& a) { return a.name == "right ear top (proposed)"; }));
}

TEST(AnchorProposals, StandBackWhereTheUserGaveTwoAnchors) {
  Sketch sketch = with_marker({0, 1, 0.4});
  const TriMesh capsule = tests::capsule(4, 24, 45);
  sketch.anchors = {{"a", {"south", "north"}, vertex_near(capsule, {1, 0, 0})},
                    {"b", {"south", "north"}, vertex_near(capsule, {-1, 0, 0})}};
  EXPECT_EQ(capsule_in_halves(sketch, true).anchors.size(), 2U);
  sketch.anchors.pop_back();
  EXPECT_EQ(capsule_in_halves(sketch, true).anchors.size(), 3U);
}

TEST(AnchorProposals, DecideNothingWhereModelsArePaired) {
  const SegmentedModel plain = capsule_in_halves(with_marker({0, 1, 0.4}), false);
  const SegmentedModel proposing = capsule_in_halves(with_marker({0, 1, 0.4}), true);
  EXPECT_TRUE(compare_segmentations(plain, proposing).empty());
  const ModelPair pair = pair_models(proposing, proposing);
  EXPECT_TRUE(pair.anchors.empty());
  EXPECT_TRUE(pair_models(plain, proposing).warnings.empty());
}

}  // namespace
}  // namespace partwise
