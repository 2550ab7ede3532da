#include "io/schema_validation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "error.h"
#include "io/document_kinds.h"
#include "io/embedded_schemas.h"
#include "io/stage_documents.h"
#include "stage_samples.h"

namespace partwise::io {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files(const std::string& folder) {
  std::vector<fs::path> result;
  for (const auto& entry : fs::directory_iterator(fs::path(PARTWISE_SCHEMAS) / folder)) {
    if (entry.path().extension() == ".json") result.push_back(entry.path());
  }
  std::sort(result.begin(), result.end());
  return result;
}

Json read(const fs::path& path) {
  std::ifstream in(path);
  return Json::parse(in);
}

/// "segment-1" of "segment-1.no-parts.json".
std::string schema_name(const fs::path& path) {
  const std::string name = path.filename().string();
  return name.substr(0, name.find('.'));
}

std::string complaint(const Json& document) {
  try {
    validate_metadata(document);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(SchemaValidation, EverySchemaIsEmbedded) {
  std::set<std::string> names, embedded;
  for (const fs::path& path : files("")) {
    names.insert(path.filename());
    EXPECT_EQ(read(path), Json::parse(embedded_schemas().at(path.filename())));
  }
  for (const auto& [name, text] : embedded_schemas()) embedded.insert(name);
  EXPECT_EQ(names, embedded);
}

TEST(SchemaValidation, ValidExamplesPass) {
  std::set<std::string> shown;
  for (const fs::path& path : files("examples/valid")) {
    const Json document = read(path);
    EXPECT_EQ(document["schema"], "partwise/" + schema_name(path));
    EXPECT_EQ(complaint(document), "") << path;
    shown.insert(schema_name(path));
  }
  shown.insert("common-1");
  EXPECT_EQ(shown.size(), embedded_schemas().size());
}

TEST(SchemaValidation, SketchesOfThePipelinesPass) {
  const std::vector<fs::path> sketches = files("../pipelines/sketches");
  EXPECT_FALSE(sketches.empty());
  for (const fs::path& path : sketches) EXPECT_EQ(complaint(read(path)), "") << path;
}

TEST(SchemaValidation, InvalidExamplesFailWhereTheySay) {
  std::set<std::string> shown;
  for (const fs::path& path : files("examples/invalid")) {
    const Json document = read(path);
    const Json& wrong = document.at("x-wrong");
    const std::string message = complaint(document);
    EXPECT_EQ(message.rfind("metadata " + wrong["at"].get<std::string>() + ": ", 0), 0U)
        << path << ": " << message;
    EXPECT_NE(message.find(wrong["says"].get<std::string>()), std::string::npos) << path << ": " << message;
    shown.insert(schema_name(path));
  }
  shown.insert("common-1");
  EXPECT_EQ(shown.size(), embedded_schemas().size());
}

TEST(SchemaValidation, EveryFigureOfAMeasureIsRequired) {
  const Json measure = read(fs::path(PARTWISE_SCHEMAS) / "examples/valid/measure-1.json");
  for (const auto& [figure, value] : measure.items()) {
    Json without = measure;
    without.erase(figure);
    EXPECT_NE(complaint(without).find(figure), std::string::npos) << figure;
  }
}

TEST(SchemaValidation, WhatTheStagesWritePasses) {
  EXPECT_EQ(complaint(to_document(tests::sample_segmented_model().mesh).metadata), "");
  EXPECT_EQ(complaint(to_document(tests::sample_segmented_model()).metadata), "");
  EXPECT_EQ(complaint(to_document(tests::sample_open_model()).metadata), "");
  EXPECT_EQ(complaint(to_document(tests::sample_hulled_model()).metadata), "");
  EXPECT_EQ(complaint(to_document(tests::sample_hull_map()).metadata), "");
  EXPECT_EQ(complaint(to_document(tests::sample_cross_map()).metadata), "");
  EXPECT_EQ(complaint(to_document(tests::sample_compatible_mesh()).metadata), "");
}

TEST(SchemaValidation, MembersOfDocumentsAreKnownFields) {
  // A stage forwards the fields that it does not know: those of the schemas must not be among them.
  for (const DocumentKind& kind : document_kinds()) {
    const std::string file = kind.name + "-" + std::to_string(kind.major) + ".schema.json";
    const Json schema = Json::parse(embedded_schemas().at(file));
    for (const auto& [name, value] : schema["properties"].items()) EXPECT_TRUE(is_known_field(name)) << name;
  }
  EXPECT_FALSE(is_known_field("laboratory"));
}

TEST(SchemaValidation, UnknownMembersOfDocumentsAreAllowed) {
  Json document = to_document(tests::sample_segmented_model()).metadata;
  document["parts"][0]["colour of the eyes"] = "green";
  document["laboratory"] = {1, 2};
  EXPECT_EQ(complaint(document), "");
}

TEST(SchemaValidation, AnythingButAnObjectIsRefused) {
  EXPECT_NE(complaint(Json()), "");
  EXPECT_NE(complaint(Json::array({"schema"})), "");
  EXPECT_NE(complaint({{"schema", 3}}), "");
  EXPECT_NE(complaint({{"schema", "partwise/"}}), "");
}

}  // namespace
}  // namespace partwise::io
