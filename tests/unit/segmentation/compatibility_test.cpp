#include "segmentation/compatibility.h"

#include <gtest/gtest.h>

#include <cmath>

#include "builders.h"
#include "segmentation/sketches.h"

namespace partwise {
namespace {

using Sentences = std::vector<std::string>;

/// Labels every facet by a function of its centroid.
template <class Label>
SegmentedModel labelled(const TriMesh& mesh, const std::vector<std::string>& names, Label label) {
  std::vector<int> labels;
  for (const auto& [a, b, c] : mesh.facets()) {
    labels.push_back(label(Vec3((mesh.point(a) + mesh.point(b) + mesh.point(c)) / 3)));
  }
  return {mesh, trace_boundaries(mesh, names, labels), {}, {}, {}};
}

int thirds(const Vec3& p) {
  return p.z() > 0.4 ? 0 : p.z() > -0.4 ? 1 : 2;
}

TEST(Compatibility, AModelIsCompatibleWithItselfWhateverItsOrderOfParts) {
  const TriMesh mesh = tests::sphere(8);
  const SegmentedModel a = labelled(mesh, {"top", "belt", "bottom"}, thirds);
  const SegmentedModel b =
      labelled(tests::sphere(11), {"bottom", "belt", "top"}, [](const Vec3& p) { return 2 - thirds(p); });
  EXPECT_EQ(compare_segmentations(a, a), Sentences());
  EXPECT_EQ(compare_segmentations(a, b), Sentences());
}

TEST(Compatibility, NamesPartsThatOnlyOneModelHas) {
  const TriMesh mesh = tests::sphere(8);
  const SegmentedModel a = labelled(mesh, {"top", "belt", "bottom"}, thirds);
  const SegmentedModel b = labelled(mesh, {"top", "waist", "bottom"}, thirds);
  EXPECT_EQ(compare_segmentations(a, b), (Sentences{"part 'belt' exists only in the first model",
                                                    "part 'waist' exists only in the second model"}));
}

TEST(Compatibility, NamesPartsThatMeetInOneModelOnly) {
  const TriMesh mesh = tests::sphere(8);
  const std::vector<std::string> names{"top", "belt", "bottom"};
  const SegmentedModel a = labelled(mesh, names, thirds);
  const SegmentedModel b = labelled(mesh, names, [](const Vec3& p) {
    return p.z() > 0.4 ? 0 : p.z() > -0.4 && p.x() > 0 ? 1 : 2;
  });
  const Sentences differences = compare_segmentations(a, b);
  const auto has = [&](const std::string& text) {
    return std::any_of(differences.begin(), differences.end(),
                       [&](const std::string& s) { return s.find(text) != std::string::npos; });
  };
  EXPECT_TRUE(has("part 'belt' has 2 boundary loops in the first model and 1 in the second"));
  EXPECT_TRUE(has("the parts 'bottom' and 'top' meet only in the second model (at vertex "));
  EXPECT_TRUE(has("(counterclockwise) meet in 0 points of the first model and 1 of the second"));
  EXPECT_FALSE(has("genus"));
}

TEST(Compatibility, CountsCurvesLoopsAndGenus) {
  const TriMesh ring = tests::torus(3, 1, 24, 10);
  const SegmentedModel halves = labelled(ring, {"a", "b"}, [](const Vec3& p) { return p.x() > 0 ? 0 : 1; });
  const SegmentedModel bite =
      labelled(ring, {"a", "b"}, [](const Vec3& p) { return p.x() > 3.2 && std::abs(p.y()) < 1.5 ? 0 : 1; });
  const Sentences differences = compare_segmentations(halves, bite);
  ASSERT_EQ(differences.size(), 4U);
  EXPECT_EQ(differences[0], "part 'a' has 2 boundary loops in the first model and 1 in the second");
  EXPECT_EQ(differences[1], "part 'b' has 2 boundary loops in the first model and 1 in the second");
  EXPECT_EQ(differences[2], "part 'b' has genus 0 in the first model and 1 in the second");
  EXPECT_NE(differences[3].find("the parts 'a' and 'b' share 2 boundary curves in the first model"),
            std::string::npos);
}

TEST(Compatibility, TellsAModelFromItsMirrorImage) {
  const TriMesh mesh = tests::sphere(8);
  auto sectors = [](double sign) {
    return [sign](const Vec3& p) { return p.x() > 0 ? 0 : sign * p.y() > 0 ? 1 : 2; };
  };
  auto caps = [&](double sign) {
    return labelled(mesh, {"a", "b", "c", "cap"},
                    [&, sign](const Vec3& p) { return p.z() > 0.5 ? 3 : sectors(sign)(p); });
  };
  EXPECT_EQ(compare_segmentations(caps(1), caps(1)), Sentences());
  EXPECT_FALSE(compare_segmentations(caps(1), caps(-1)).empty());
}

TEST(Compatibility, NamesLandmarksOfOneModel) {
  const TriMesh mesh = tests::sphere(8);
  SegmentedModel a = labelled(mesh, {"top", "belt", "bottom"}, thirds), b = a;
  a.markers = {{"nose", {0, Vec3(1, 0, 0)}}};
  b.anchors = {{"front", 0, 1, 5}};
  EXPECT_EQ(compare_segmentations(a, b), (Sentences{"marker 'nose' exists only in the first model",
                                                    "anchor 'front' exists only in the second model"}));
  b.markers = a.markers;
  a.anchors = {{"front", 2, 1, 5}};
  EXPECT_EQ(
      compare_segmentations(a, b),
      (Sentences{"anchor 'front' lies between 'belt' and 'bottom' in the first model and between 'belt' "
                 "and 'top' in the second"}));
}

TEST(Compatibility, ReportsMarkersInDifferentPartsSeparately) {
  const TriMesh mesh = tests::sphere(8);
  SegmentedModel a = labelled(mesh, {"top", "belt", "bottom"}, thirds), b = a;
  const auto facet_of = [&](int part) {
    const auto& labels = a.segmentation.labels;
    return static_cast<int>(std::find(labels.begin(), labels.end(), part) - labels.begin());
  };
  const Vec3 inside(0.3, 0.3, 0.4);
  a.markers = {{"m", {facet_of(0), inside}}};
  b.markers = {{"m", {facet_of(2), inside}}};
  EXPECT_EQ(compare_segmentations(a, b), Sentences());
  EXPECT_EQ(misplaced_markers(a, b),
            Sentences{"marker 'm' lies in part 'top' of the first model and in 'bottom' of the second"});
  EXPECT_EQ(misplaced_markers(a, a), Sentences());
}

TEST(Compatibility, SinglePartsCorrespondWhateverTheyAreCalled) {
  const auto one = [](const Vec3&) { return 0; };
  const SegmentedModel a = labelled(tests::sphere(4), {"whole"}, one);
  const SegmentedModel b = labelled(tests::cube(3), {"box"}, one);
  const SegmentedModel open = labelled(tests::hemisphere(4), {"cap"}, one);
  EXPECT_EQ(compare_segmentations(a, b), Sentences());
  EXPECT_EQ(compare_segmentations(a, open).size(), 2U);  // a loop, a curve to the outside
}

}  // namespace
}  // namespace partwise
