#include "segmentation/cut_proposals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "builders.h"
#include "segmentation/cut_sketch.h"
#include "segmentation/segment_mesh.h"
#include "segmentation/sketches.h"

namespace partwise {
namespace {

/// A ball with six arms along the axes.
TriMesh jack() {
  return tests::bumpy_sphere(24, 2.5);
}

SegmentationOptions proposing() {
  SegmentationOptions options;
  options.propose_cuts = true;
  options.tau = 0.05;
  return options;
}

/// The tips: the ends of the two arms along x are one part with the ball; "top" is the end of the arm along
/// z.
Sketch top_and_rest(const TriMesh& mesh) {
  Sketch sketch;
  sketch.parts = {
      tests::part_at(mesh, "rest", {{0, 0, -3}, {3, 0, 0}, {-3, 0, 0}, {0, -3, 0}, {0.7, 0.7, 0}}),
      tests::part_at(mesh, "top", {{0, 0, 3.5}, {0, 0, 3}})};
  return sketch;
}

void expect_useful(const SegmentedMesh& segmented) {
  for (const CutProposal& proposal : segmented.cuts) {
    const Concavity& before = segmented.model.concavity[proposal.part];
    ASSERT_GE(proposal.pieces.size(), 2U);
    for (const ProposedPiece& piece : proposal.pieces) {
      EXPECT_LT(piece.concavity.largest, before.largest) << piece.name;
      EXPECT_FALSE(piece.strokes.empty()) << piece.name;
    }
    EXPECT_FALSE(proposal.curves.empty());
    for (const BoundaryCurve& curve : proposal.curves) {
      EXPECT_GT(curve.length, 0);
      EXPECT_LT(curve.right, static_cast<int>(proposal.pieces.size()));
    }
    for (std::size_t f = 0; f < proposal.piece_of_facet.size(); ++f) {
      EXPECT_EQ(proposal.piece_of_facet[f] >= 0, segmented.model.segmentation.labels[f] == proposal.part);
    }
  }
}

TEST(CutProposals, CutTheArmsOffAStar) {
  const TriMesh mesh = jack();
  const SegmentedMesh segmented = segment_mesh(mesh, {}, proposing());
  ASSERT_EQ(segmented.cuts.size(), 1U);
  expect_useful(segmented);
  const CutProposal& cut = segmented.cuts[0];
  double worst = 0;
  std::set<std::string> names;
  for (const ProposedPiece& piece : cut.pieces) {
    worst = std::max(worst, piece.concavity.largest);
    names.insert(piece.name);
  }
  EXPECT_LT(worst, 0.6 * segmented.model.concavity[0].largest);
  EXPECT_TRUE(names.contains("whole"));
  EXPECT_TRUE(names.contains("whole 2"));
  EXPECT_EQ(names.size(), cut.pieces.size());
  ASSERT_EQ(segmented.warnings.size(), 1U);
  EXPECT_NE(segmented.warnings[0].find("; suggestion: cut it into "), std::string::npos);
  EXPECT_NE(segmented.warnings[0].find("through vertices " + std::to_string(cut.curves[0].vertices[0])),
            std::string::npos);
}

TEST(CutProposals, MeasureWhatTheSameStrokesGive) {
  const TriMesh mesh = jack();
  const SegmentedMesh segmented = segment_mesh(mesh, {}, proposing());
  const CutSketch cut = with_cuts({}, segmented, proposing());
  ASSERT_EQ(cut.sketch.parts.size(), segmented.cuts[0].pieces.size());
  const SegmentedMesh again = segment_mesh(mesh, cut.sketch, {});
  double worst = 0;
  for (std::size_t k = 0; k < cut.sketch.parts.size(); ++k) {
    EXPECT_NEAR(again.model.concavity[k].largest, segmented.cuts[0].pieces[k].concavity.largest, 1e-12);
    worst = std::max(worst, again.model.concavity[k].largest);
  }
  EXPECT_DOUBLE_EQ(cut.largest_concavity, worst);
}

TEST(CutProposals, AreOnlyMadeWhenAskedForAndAboveTau) {
  const TriMesh mesh = jack();
  SegmentationOptions options = proposing();
  options.propose_cuts = false;
  EXPECT_TRUE(segment_mesh(mesh, {}, options).cuts.empty());
  options = proposing();
  options.tau = 0.9;
  EXPECT_TRUE(segment_mesh(mesh, {}, options).cuts.empty());
  EXPECT_TRUE(segment_mesh(tests::sphere(8), {}, proposing()).cuts.empty());
}

TEST(CutProposals, DoNotChangeTheSegmentationNorWithScaleAndPlace) {
  const TriMesh body = jack();
  const Sketch sketch = top_and_rest(body);
  const SegmentedMesh plain = segment_mesh(body, sketch, {});
  const SegmentedMesh proposed = segment_mesh(body, sketch, proposing());
  EXPECT_EQ(plain.model.segmentation.labels, proposed.model.segmentation.labels);
  ASSERT_EQ(proposed.cuts.size(), 1U);
  expect_useful(proposed);
  Points points = body.points();
  for (Vec3& p : points) p = 1024 * p + Vec3(64, 128, -32);
  const SegmentedMesh moved = segment_mesh(body.with_points(points), sketch, proposing());
  ASSERT_EQ(moved.cuts.size(), 1U);
  EXPECT_EQ(moved.cuts[0].pieces.size(), proposed.cuts[0].pieces.size());
}

TEST(CutSketch, SharesOutStrokesAndKeepsTheOtherParts) {
  const TriMesh mesh = jack();
  Sketch sketch = top_and_rest(mesh);
  sketch.parts[0].strokes.emplace_back(PointStroke{{{0, 3, 0}, {0, 3.2, 0}}});
  sketch.markers = {{"tip", SurfacePoint{3, Vec3(0.25, 0.25, 0.5)}}};
  const SegmentedMesh whole = segment_mesh(mesh, sketch, proposing());
  const BoundaryCurve& neck = whole.model.segmentation.curves.at(0);
  sketch.anchors = {{"collar", {"rest", "top"}, neck.vertices[0]}};
  const SegmentedMesh segmented = segment_mesh(mesh, sketch, proposing());
  const CutSketch cut = with_cuts(sketch, segmented, proposing());
  ASSERT_GT(cut.sketch.parts.size(), 2U);
  EXPECT_EQ(cut.sketch.parts[0].name, "rest");
  EXPECT_EQ(cut.sketch.parts[1].name, "top");
  EXPECT_EQ(cut.sketch.parts[1].strokes.size(), 1U);
  EXPECT_EQ(cut.sketch.markers.size(), 1U);
  ASSERT_EQ(cut.sketch.anchors.size() + cut.lost_anchors.size(), 1U);
  // Every vertex that was drawn for a part still is, for the piece that it lies in.
  const SegmentedMesh after = segment_mesh(mesh, cut.sketch, {});
  EXPECT_LT(after.model.concavity[0].largest, segmented.model.concavity[0].largest);
  for (const int v : std::get<VertexStroke>(sketch.parts[0].strokes[0]).vertices) {
    const auto holds = [&](const SketchedPart& part) {
      return std::any_of(part.strokes.begin(), part.strokes.end(), [&](const Stroke& stroke) {
        const auto* given = std::get_if<VertexStroke>(&stroke);
        return given != nullptr && std::count(given->vertices.begin(), given->vertices.end(), v) > 0;
      });
    };
    EXPECT_EQ(std::count_if(cut.sketch.parts.begin(), cut.sketch.parts.end(), holds), 1) << v;
  }
}

TEST(CutSketch, WithoutCutsIsTheSketch) {
  const TriMesh mesh = tests::sphere(8);
  const CutSketch cut = with_cuts({}, segment_mesh(mesh, {}, proposing()), proposing());
  ASSERT_EQ(cut.sketch.parts.size(), 1U);
  EXPECT_TRUE(cut.sketch.parts[0].strokes.empty());
}

}  // namespace
}  // namespace partwise
