#include "report/findings.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "builders.h"

namespace partwise::report {
namespace {

using io::Json;

// Eleven stages of which each was made from those before.
RunDocuments finished_run() {
  RunDocuments run;
  const auto stage = [&](const std::string& title, const std::vector<std::string>& inputs) {
    StageState state{title, title + ".ply", "", false, Json::object(), "digest of " + title};
    Json parents = Json::array();
    for (const std::string& input : inputs) parents.push_back({{"sha256", "digest of " + input}});
    state.metadata = {{"history", {{{"tool", title}, {"inputs", parents}}}}, {"metrics", Json::object()}};
    run.stages.push_back(state);
  };
  for (const std::string side : {" (source)", " (target)"}) {
    stage("segment" + side, {});
    stage("hull" + side, {"segment" + side});
    stage("map-to-hull" + side, {"hull" + side});
  }
  stage("hull-to-hull", {"map-to-hull (source)", "map-to-hull (target)"});
  stage("reconstruct", {"hull-to-hull"});
  stage("critical-points", {"reconstruct"});
  stage("relocate", {"critical-points"});
  stage("measure", {"relocate"});
  const TriMesh mesh = tests::tetrahedron();
  std::vector<SurfacePoint> images(4);
  for (int f = 0; f < 4; ++f) {
    for (int i = 0; i < 3; ++i) images[mesh.facet(f)[i]] = {f, Vec3::Unit(i)};
  }
  run.compatible.emplace(
      CompatibleMesh{mesh, mesh, mesh.points(), SurfaceMap(mesh, mesh, images), {}, {}, {}, {}, {}});
  run.measure = {{"one_to_one", true}, {"source_faces", 4}, {"flipped_faces", 0}};
  return run;
}

std::vector<std::string> texts(const RunDocuments& run, Finding::Weight weight) {
  std::vector<std::string> result;
  for (const Finding& finding : findings(run)) {
    if (finding.weight == weight) result.push_back(finding.stage + ": " + finding.text);
  }
  return result;
}

using Weight = Finding::Weight;

TEST(Findings, AGoodRunHasNone) {
  EXPECT_TRUE(findings(finished_run()).empty());
}

TEST(Findings, AMissingStageIsAFailureUnlessTheResultIsThere) {
  RunDocuments run = finished_run();
  run.stages[7].missing = true;
  run.stages[7].trouble = "there is no such file";
  EXPECT_TRUE(texts(run, Weight::failure).empty());
  EXPECT_EQ(texts(run, Weight::note).size(), 1U);
  run.compatible.reset();
  EXPECT_EQ(texts(run, Weight::failure).size(), 1U);
}

TEST(Findings, ADocumentMadeFromAnotherOneIsNamed) {
  RunDocuments run = finished_run();
  run.stages[4].digest = "another";
  const std::vector<std::string> found = texts(run, Weight::warning);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].starts_with("map-to-hull (target): "));
  EXPECT_NE(found[0].find("hull (target)"), std::string::npos);
}

TEST(Findings, FiguresAreJudged) {
  RunDocuments run = finished_run();
  run.measure["one_to_one"] = false;
  run.measure["certificate"] = {{"reason", "a handle"}};
  run.measure["flipped_faces"] = 1;
  run.measure["undefined"] = {{"marker_error_max", "there are no markers"}};
  const std::vector<std::string> warnings = texts(run, Weight::warning);
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_NE(warnings[0].find("a handle"), std::string::npos);
  EXPECT_NE(warnings[1].find("1 facet faces"), std::string::npos);
  EXPECT_NE(warnings[1].find("25"), std::string::npos);  // of four facets one is a quarter
  EXPECT_EQ(texts(run, Weight::note).size(), 1U);
}

TEST(Findings, FoldsAndReleasedMarkersComeFromTheMetrics) {
  RunDocuments run = finished_run();
  run.stages[9].metadata["metrics"] = {
      {"source", {{"map-to-hull", {{"parts", {{"head", {{"folds", 3}}}, {"tail", {{"folds", 0}}}}}}}}},
      {"hull-to-hull", {{"parts", {{"head", {{"folds", 0}, {"released_markers", {"nose"}}}}}}}}};
  const std::vector<std::string> found = texts(run, Weight::warning);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NE(found[0].find("\"head\" has 3 folded facets"), std::string::npos);
  EXPECT_NE(found[1].find("\"nose\""), std::string::npos);
}

}  // namespace
}  // namespace partwise::report
