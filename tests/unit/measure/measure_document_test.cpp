#include "measure/measure_document.h"

#include <gtest/gtest.h>

#include <limits>

#include "io/schema_validation.h"
#include "measure/figures_table.h"

namespace partwise {
namespace {

using io::Json;

Measurement some_measurement() {
  Measurement m;
  m.source_facets = 14410;
  m.target_facets = 9996;
  m.parts = 7;
  m.target_diagonal = 2;
  m.distance = {{0.002, 0.02, 0.01}, {0.004, 0.06, 0.05}, 0.003, 0.06};
  m.flipped_facets = 3;
  m.self_intersections = {27, 86, 172};
  m.degenerate_facets = 1;
  m.distortion = Distortion{0.8, 5.5, 4.5, 12, 1};
  const SphereCertificate side{14410, 2, 0, 1, {}};
  m.certificate.pieces = {{"whole", side, side, {}}};
  m.marker_errors = {{"nose", 0.001}, {"tail", 0.004}, {"paw", 0.002}};
  return m;
}

Json hull_map(int head, int body, bool certified) {
  return {{"one_to_one", certified}, {"parts", {{"head", {{"folds", head}}}, {"body", {{"folds", body}}}}}};
}

Json all_metrics(const Json& source, const Json& target, const Json& cross) {
  return {{"source", {{"map-to-hull", source}}},
          {"target", {{"map-to-hull", target}}},
          {"hull-to-hull", cross},
          {"reconstruct", {{"boundary_gap_max", 0.25}}}};
}

TEST(StageFigures, FoldsAreSummedOverMapsAndParts) {
  const StageFigures figures =
      stage_figures(all_metrics(hull_map(1, 0, false), hull_map(0, 2, false),
                                {{"one_to_one", false}, {"parts", {{"head", {{"folds", 4}}}}}}));
  ASSERT_TRUE(figures.hull_folds);
  EXPECT_EQ(figures.hull_folds->total, 7);
  EXPECT_EQ(figures.hull_folds->parts, (std::map<std::string, int>{{"head", 5}, {"body", 2}}));
  EXPECT_FALSE(figures.hull_folds->certified);
  EXPECT_EQ(figures.boundary_gap_max, 0.25);
}

TEST(StageFigures, MapsWithoutFoldsAreCertifiedOnlyByTheirCertificates) {
  const Json good = hull_map(0, 0, true), covers_twice = hull_map(0, 0, false);
  EXPECT_TRUE(stage_figures(all_metrics(good, good, good)).hull_folds->certified);
  EXPECT_FALSE(stage_figures(all_metrics(good, covers_twice, good)).hull_folds->certified);
}

TEST(StageFigures, AMapThatWasNotCountedLeavesFoldsUndefined) {
  Json metrics = all_metrics(hull_map(0, 0, true), hull_map(0, 0, true), hull_map(0, 0, true));
  metrics["target"].erase("map-to-hull");
  EXPECT_FALSE(stage_figures(metrics).hull_folds);
  EXPECT_FALSE(stage_figures(Json::object()).hull_folds);
  EXPECT_FALSE(stage_figures(nullptr).boundary_gap_max);
  EXPECT_FALSE(stage_figures({{"hull-to-hull", "text"}, {"source", 7}}).hull_folds);
}

TEST(MeasureDocument, FitsItsSchemaAndIsRelativeToTheDiagonal) {
  StageFigures stages;
  stages.hull_folds = HullFoldCounts{0, {{"head", 0}}, true};
  stages.boundary_gap_max = 0;
  const Json document = measure_document(some_measurement(), stages);
  EXPECT_NO_THROW(io::validate_metadata(document));
  EXPECT_EQ(document["rms_distance"], 0.0015);
  EXPECT_EQ(document["max_distance"], 0.03);
  EXPECT_EQ(document["on_surface_max"], 0.005);
  EXPECT_EQ(document["distances"]["target_to_compatible"]["rms"], 0.002);
  EXPECT_EQ(document["marker_error_max"], 0.004);
  EXPECT_EQ(document["marker_worst"], "tail");
  EXPECT_EQ(document["self_intersections"]["target"], 172);
  EXPECT_EQ(document["one_to_one"], true);
  EXPECT_EQ(document["certificate"]["pieces"][0]["target"]["degree"], 1);
  EXPECT_FALSE(document.contains("undefined"));
  EXPECT_FALSE(document.contains("truth"));
}

TEST(MeasureDocument, UndefinedFiguresAreNullWithAReason) {
  Measurement measurement = some_measurement();
  measurement.distortion.reset();
  measurement.marker_errors.clear();
  measurement.truth = GroundTruthErrors{};
  measurement.truth->vertices = 10;
  measurement.truth->unreachable = 1;
  measurement.truth->mean = measurement.truth->max = std::numeric_limits<double>::infinity();
  const Json document = measure_document(measurement, {});
  EXPECT_NO_THROW(io::validate_metadata(document));
  for (const char* name : {"l2_stretch_efficiency", "symmetric_dirichlet", "angle_error_deg",
                           "marker_error_max", "hull_folds", "boundary_gap_max"}) {
    EXPECT_TRUE(document.at(name).is_null()) << name;
    EXPECT_TRUE(document["undefined"][name].is_string()) << name;
  }
  EXPECT_TRUE(document["truth"]["mean"].is_null());
  EXPECT_EQ(document["truth"]["median"], 0);
}

TEST(FiguresTable, HasALinePerFigure) {
  const std::string table = figures_table({"cat-lion", measure_document(some_measurement(), {})});
  EXPECT_EQ(table.rfind("cat-lion", 0), 0U);
  EXPECT_NE(table.find("14410\n"), std::string::npos);
  EXPECT_NE(table.find("3.000\n"), std::string::npos);
  EXPECT_NE(table.find("tail\n"), std::string::npos);
  EXPECT_EQ(table.find("geodesic"), std::string::npos) << "no lines for a ground truth that was not given";
}

TEST(SummaryTable, HasALinePerDocumentAndAlignedColumns) {
  const Json document = measure_document(some_measurement(), {});
  const std::string table =
      summary_table({{"cat-lion", document}, {"a", document}, {"broken", Json::object()}});
  std::vector<std::string> lines;
  for (std::size_t start = 0; start < table.size();) {
    const std::size_t end = table.find('\n', start);
    lines.push_back(table.substr(start, end - start));
    start = end + 1;
  }
  ASSERT_EQ(lines.size(), 4U);
  for (const std::string& line : lines) EXPECT_EQ(line.size(), lines[0].size());
  EXPECT_NE(lines[1].find("0.150"), std::string::npos);
  EXPECT_EQ(lines[3].find_first_of("0123456789"), std::string::npos);
  EXPECT_EQ(lines[0].find("truth"), std::string::npos) << "no column without a value";
}

}  // namespace
}  // namespace partwise
