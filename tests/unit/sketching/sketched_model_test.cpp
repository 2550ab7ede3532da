#include "sketching/sketched_model.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "builders.h"
#include "error.h"
#include "io/sketch.h"
#include "report/page_arrays.h"
#include "segmentation/sketches.h"
#include "sketching/scratch_folder.h"

namespace partwise::sketching {
namespace {

using io::Json;
using tests::ScratchFolder;

/// Looks along -y at the irregular body from y = 12: x to the left, z up; 400 x 400 pixels.
Json camera_from_behind() {
  return Json::parse(R"({"view": [-1,0,0,0, 0,0,1,0, 0,1,0,-12, 0,0,0,1],
                         "projection": [4,0,0,0, 0,4,0,0, 0,0,-1.02,-0.202, 0,0,-1,0],
                         "viewport": [400, 400]})");
}

/// Two parts drawn on the screen, one above the other.
Json drawn_sketch() {
  const Json camera = camera_from_behind();
  return {
      {"schema", "partwise/sketch-1"},
      {"parts",
       {{{"name", "top"}, {"strokes", {{{"screen", {{205.5, 110.25}, {215, 150}}}, {"camera", camera}}}}},
        {{"name", "bottom"}, {"strokes", {{{"screen", {{190, 260}, {205, 290.125}}}, {"camera", camera}}}}}}},
      {"markers", {{{"name", "tip"}, {"face", 3}, {"barycentric", {0.2, 0.3, 0.5}}}}},
      {"anchors", Json::array()}};
}

std::string labels_of(const Segmentation& segmentation) {
  return report::base64(std::string(segmentation.labels.begin(), segmentation.labels.end()));
}

class SketchedModelTest : public testing::Test {
 protected:
  std::string saved() const {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  ScratchFolder folder;
  TriMesh body = tests::irregular_body();
  std::string path = folder.path("body.sketch.json");
};

TEST_F(SketchedModelTest, SavedSketchesReplayToTheShownLabels) {
  SketchedModel drawn(folder.path("body.ply"), body, path);
  drawn.put(drawn_sketch().dump());
  const SegmentedMesh replayed = segment_mesh(body, io::read_sketch(path), {});
  ASSERT_TRUE(drawn.result().contains("labels")) << drawn.result();
  EXPECT_EQ(drawn.result()["labels"], labels_of(replayed.model.segmentation));
  ASSERT_EQ(drawn.result()["parts"].size(), 2U);
  for (const Json& part : drawn.result()["parts"]) EXPECT_GT(part["facets"], body.facet_count() / 10);
  EXPECT_EQ(drawn.result()["markers"][0]["face"], 3);

  SketchedModel reopened(folder.path("body.ply"), body, path);
  EXPECT_EQ(reopened.sketch(), drawn.sketch());
  EXPECT_EQ(reopened.result()["labels"], drawn.result()["labels"]);
}

TEST_F(SketchedModelTest, MarkersAndNamesChangeOverKeptLabels) {
  SketchedModel often(folder.path("body.ply"), body, path);
  Json sketch = drawn_sketch();
  const auto expect_as_anew = [&](const char* what) {
    SketchedModel once(folder.path("body.ply"), body, folder.path("other.sketch.json"));
    for (SketchedModel* model : {&often, &once}) model->put(sketch.dump());
    Json results[] = {often.result(), once.result()};
    for (Json& result : results) result.erase("seconds");
    EXPECT_EQ(results[0], results[1]) << what;
  };
  expect_as_anew("as drawn");
  sketch["markers"].push_back({{"name", "side"}, {"face", 40}, {"barycentric", {0.5, 0.25, 0.25}}});
  expect_as_anew("one more marker");
  EXPECT_EQ(often.result()["markers"].size(), 2U);
  sketch["anchors"].push_back({{"name", "a"}, {"between", {"top", "bottom"}}, {"vertex", 1000000}});
  expect_as_anew("an anchor at no vertex");
  EXPECT_TRUE(often.result().contains("problem"));
  sketch["anchors"].clear();
  sketch["parts"][0]["name"] = "upper";
  expect_as_anew("another name");
  EXPECT_EQ(often.result()["parts"][0]["name"], "upper");
  sketch["parts"][1]["strokes"].push_back({{"vertices", {0}}});
  expect_as_anew("one more stroke");
}

TEST_F(SketchedModelTest, LabelsDoNotDependOnWhatWasDrawnBefore) {
  SketchedModel often(folder.path("body.ply"), body, path);
  Json fewer = drawn_sketch();
  fewer["parts"].erase(1);
  often.put(fewer.dump());
  EXPECT_EQ(often.segmented()->segmentation.part_count(), 1);
  often.put(drawn_sketch().dump());
  SketchedModel once(folder.path("body.ply"), body, folder.path("other.sketch.json"));
  once.put(drawn_sketch().dump());
  EXPECT_EQ(often.result()["labels"], once.result()["labels"]);
}

TEST_F(SketchedModelTest, PartsWithoutStrokesAreSavedButNotCut) {
  SketchedModel drawn(folder.path("body.ply"), body, path);
  Json sketch = drawn_sketch();
  sketch["parts"].push_back({{"name", "side"}, {"strokes", Json::array()}});
  sketch["anchors"].push_back({{"name", "seam"}, {"between", {"top", "side"}}, {"vertex", 7}});
  drawn.put(sketch.dump());
  ASSERT_TRUE(drawn.result().contains("parts")) << drawn.result();
  EXPECT_EQ(drawn.result()["parts"].size(), 2U);
  EXPECT_TRUE(drawn.result()["anchors"].empty());
  EXPECT_EQ(io::read_sketch(path).parts.size(), 3U);
}

TEST_F(SketchedModelTest, HintsAreThoseOfSegment) {
  const TriMesh jack = tests::bumpy_sphere(24, 2.5);  // a ball with six arms
  const SketchedModel model(folder.path("jack.ply"), jack, path);
  SegmentationOptions options;
  options.propose_cuts = true;
  const SegmentedMesh segmented = segment_mesh(jack, {}, options);
  ASSERT_EQ(segmented.cuts.size(), 1U);
  const Json found = hints(*model.segmented());
  const Concavity& concavity = segmented.model.concavity[0];
  EXPECT_EQ(
      found["concave"],
      Json::array({{{"part", "whole"}, {"concavity", concavity.largest}, {"deepest", concavity.vertex}}}));
  ASSERT_EQ(found["proposed_cuts"].size(), 1U);
  EXPECT_EQ(found["proposed_cuts"][0]["part"], "whole");
  const Json& curves = found["proposed_cuts"][0]["curves"];
  ASSERT_EQ(curves.size(), segmented.cuts[0].curves.size());
  for (std::size_t i = 0; i < curves.size(); ++i) {
    EXPECT_EQ(curves[i]["vertices"], Json(segmented.cuts[0].curves[i].vertices));
  }
}

TEST_F(SketchedModelTest, ConvexPartsHaveNoHints) {
  const SketchedModel model(folder.path("ball.ply"), tests::sphere(3), path);
  EXPECT_EQ(hints(*model.segmented()), Json({{"concave", Json::array()}, {"proposed_cuts", Json::array()}}));
}

/// The vertex of `mesh` that is farthest in a direction.
int extreme(const TriMesh& mesh, const Vec3& direction) {
  int best = 0;
  for (int v = 1; v < mesh.vertex_count(); ++v) {
    if (mesh.point(v).dot(direction) > mesh.point(best).dot(direction)) best = v;
  }
  return best;
}

TEST_F(SketchedModelTest, AnAnchorThatDoesNotFitHidesNoParts) {
  const TriMesh jack = tests::bumpy_sphere(24, 2.5);
  SketchedModel drawn(folder.path("jack.ply"), jack, path);
  Json sketch = io::to_json({}, "");
  const auto add_part = [&](const char* name, const Points& directions) {
    Json strokes = Json::array();
    for (const Vec3& direction : directions) strokes.push_back({{"vertices", {extreme(jack, direction)}}});
    sketch["parts"].push_back({{"name", name}, {"strokes", strokes}});
  };
  add_part("up", {Vec3::UnitZ()});
  add_part("middle", {Vec3::UnitX(), -Vec3::UnitX(), Vec3::UnitY(), -Vec3::UnitY()});
  add_part("down", {-Vec3::UnitZ()});
  drawn.put(sketch.dump());
  const Json fitting = drawn.result();
  ASSERT_EQ(fitting["parts"].size(), 3U) << fitting;
  const Json lost{{"name", "lost"}, {"between", Json::array({"up", "down"})}, {"vertex", 0}};
  sketch["anchors"].push_back(lost);
  drawn.put(sketch.dump());
  ASSERT_TRUE(drawn.result().contains("problem")) << drawn.result();
  EXPECT_NE(drawn.result()["problem"].get<std::string>().find("lost"), std::string::npos);
  for (const char* list : {"labels", "parts", "curves"})
    EXPECT_EQ(drawn.result()[list], fitting[list]) << list;
  EXPECT_FALSE(drawn.segmented());
}

TEST_F(SketchedModelTest, WhatCannotBeCutIsSavedWithASentenceWhy) {
  SketchedModel drawn(folder.path("body.ply"), body, path);
  Json sketch = drawn_sketch();
  sketch["parts"][1]["strokes"] = {{{"vertices", {body.vertex_count()}}}};
  drawn.put(sketch.dump());
  EXPECT_FALSE(drawn.segmented());
  EXPECT_NE(drawn.result()["problem"].get<std::string>().find("part 'bottom', stroke 0"), std::string::npos);
  EXPECT_EQ(Json::parse(saved())["parts"], sketch["parts"]);
}

TEST_F(SketchedModelTest, ABadDocumentChangesNothing) {
  SketchedModel drawn(folder.path("body.ply"), body, path);
  drawn.put(drawn_sketch().dump());
  const std::string before = saved();
  const Json sketch = drawn.sketch(), result = drawn.result();
  Json unnamed = drawn_sketch();
  unnamed["parts"][0].erase("name");
  std::string deep_text = drawn_sketch().dump();
  deep_text.insert(1, "\"note\":" + std::string(200'000, '[') + std::string(200'000, ']') + ",");
  for (const std::string& text : {std::string(), std::string("{"), std::string("[1, 2]"), std::string("null"),
                                  unnamed.dump(), deep_text, std::string(1'000'000, '[')}) {
    EXPECT_THROW(drawn.put(text), InputError) << text.substr(0, 60);
  }
  EXPECT_EQ(saved(), before);
  EXPECT_EQ(drawn.sketch(), sketch);
  EXPECT_EQ(drawn.result(), result);
}

TEST_F(SketchedModelTest, KeepsTheFileAsItWasBeforeTheFirstChange) {
  const std::string original = io::to_json(tests::body_sketch(body), "by hand").dump();
  std::ofstream(path) << original;
  SketchedModel drawn(folder.path("body.ply"), body, path);
  drawn.put(drawn_sketch().dump());
  drawn.put(io::to_json({}, "").dump());
  std::ifstream in(path + "~");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), original);
}

TEST_F(SketchedModelTest, WritesThroughALink) {
  const std::string elsewhere = folder.path("elsewhere.json");
  std::ofstream(elsewhere) << io::to_json({}, "").dump();
  std::filesystem::create_symlink(elsewhere, path);
  SketchedModel drawn(folder.path("body.ply"), body, path);
  drawn.put(drawn_sketch().dump());
  EXPECT_TRUE(std::filesystem::is_symlink(path));
  EXPECT_EQ(io::read_sketch(elsewhere).parts.size(), 2U);
}

TEST_F(SketchedModelTest, RefusesTheSketchOfAnotherMesh) {
  SketchedModel(folder.path("body.ply"), body, path).put(drawn_sketch().dump());
  try {
    SketchedModel(folder.path("ball.ply"), tests::sphere(3), path);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind(path, 0), 0U) << error.what();
  }
}

TEST_F(SketchedModelTest, ComparesTwoModels) {
  SketchedModel a(folder.path("a.ply"), body, folder.path("a.sketch.json"));
  SketchedModel b(folder.path("b.ply"), body, folder.path("b.sketch.json"));
  a.put(drawn_sketch().dump());
  b.put(drawn_sketch().dump());
  EXPECT_TRUE(compare(a, b)["differences"].empty()) << compare(a, b);
  Json renamed = drawn_sketch();
  renamed["parts"][0]["name"] = "head";
  b.put(renamed.dump());
  ASSERT_FALSE(compare(a, b)["differences"].empty());
  EXPECT_NE(compare(a, b)["differences"].dump().find("head"), std::string::npos);
  renamed["parts"][0]["strokes"] = {{{"vertices", {body.vertex_count()}}}};
  b.put(renamed.dump());
  EXPECT_EQ(compare(a, b)["problem"].get<std::string>().rfind("b: ", 0), 0U);
}

TEST_F(SketchedModelTest, GeometryIsCentredOnADiagonalOfOne) {
  SketchedModel drawn(folder.path("body.ply"), body, path);
  const std::string octets = drawn.geometry();
  ASSERT_EQ(octets.size(), 12U * (body.vertex_count() + body.facet_count()));
  float first[3];
  std::memcpy(first, octets.data(), sizeof first);
  const Json facts = drawn.facts();
  for (int axis = 0; axis < 3; ++axis) {
    const double expected = (body.point(0)[axis] - facts["center"][axis].get<double>()) / body.diagonal();
    EXPECT_NEAR(first[axis], expected, 1e-6);
  }
  std::uint32_t last = 0;
  std::memcpy(&last, octets.data() + octets.size() - 4, 4);
  EXPECT_EQ(static_cast<int>(last), body.facets().back()[2]);
}

}  // namespace
}  // namespace partwise::sketching
