#include <gtest/gtest.h>

#include "builders.h"
#include "error.h"
#include "io/document.h"
#include "io/stage_documents.h"

namespace partwise::io {
namespace {

Document made(const std::vector<const Document*>& inputs, const std::string& tool, const Json& arguments) {
  Document document = to_document(tests::tetrahedron());
  document.metadata["history"] = extend_history(inputs, {tool, arguments, Json::array()});
  return document;
}

std::vector<std::string> tools(const Json& history) {
  std::vector<std::string> names;
  for (const Json& entry : history) names.push_back(entry["tool"]);
  return names;
}

TEST(History, GrowsByOneEntryPerStage) {
  const Document mesh = to_document(tests::cube(1));
  const Document segmented = made({&mesh}, "segment", {{"method", "growth"}});
  const Document hulled = made({&segmented}, "hull", Json::object());
  const Json& history = hulled.metadata["history"];
  EXPECT_EQ(tools(history), (std::vector<std::string>{"segment", "hull"}));
  EXPECT_EQ(history[0]["arguments"]["method"], "growth");
  EXPECT_EQ(history[0]["inputs"][0]["sha256"], digest(mesh));
  EXPECT_EQ(history[0]["inputs"][0]["schema"], "partwise/mesh-1");
  EXPECT_EQ(history[0]["previous"], Json::array());
  EXPECT_EQ(history[1]["inputs"][0]["sha256"], digest(segmented));
  EXPECT_EQ(history[1]["previous"], Json::array({0}));
  for (const Json& entry : history) {
    EXPECT_EQ(entry.size(), 5U) << "no clock, host or path: " << entry;
  }
}

TEST(History, MergesTwoInputsWithoutDuplicates) {
  const Document mesh = to_document(tests::cube(1));
  const Document shared = made({&mesh}, "convert-mesh", Json::object());
  const Document source = made({&shared}, "segment", {{"seed", 1}});
  const Document target = made({&shared}, "segment", {{"seed", 2}});
  const Document cross = made({&source, &target}, "hull-to-hull", Json::object());
  const Json& history = cross.metadata["history"];
  EXPECT_EQ(tools(history), (std::vector<std::string>{"convert-mesh", "segment", "segment", "hull-to-hull"}));
  EXPECT_EQ(history[1]["previous"], Json::array({0}));
  EXPECT_EQ(history[2]["previous"], Json::array({0}));
  EXPECT_EQ(history[3]["previous"], Json::array({1, 2}));
  EXPECT_EQ(history[3]["inputs"].size(), 2U);
  // The same document twice is one line of ancestors.
  EXPECT_EQ(made({&source, &source}, "hull-to-hull", {}).metadata["history"].size(), 3U);
  EXPECT_EQ(made({&source, &source}, "hull-to-hull", {}).metadata["history"][2]["previous"],
            Json::array({1}));
}

TEST(History, KeepsTheSecondBranchsOwnIndices) {
  const Document mesh = to_document(tests::cube(1)), other = to_document(tests::sphere(2));
  const Document a = made({&mesh}, "segment", {{"seed", 1}});
  const Document b = made({&other}, "convert-mesh", {});
  const Document c = made({&b}, "segment", {{"seed", 2}});
  const Json history = extend_history({&a, &c}, {"hull-to-hull", {}, Json::array()});
  EXPECT_EQ(tools(history), (std::vector<std::string>{"segment", "convert-mesh", "segment", "hull-to-hull"}));
  EXPECT_EQ(history[2]["previous"], Json::array({1}));
  EXPECT_EQ(history[3]["previous"], Json::array({0, 2}));
}

TEST(History, FurtherInputsFollowTheDocuments) {
  const Document mesh = to_document(tests::cube(1));
  const Json sketch = {{"sha256", "00"}, {"schema", "partwise/sketch-1"}};
  const Json history = extend_history({&mesh}, {"segment", {}, Json::array({sketch})});
  EXPECT_EQ(history[0]["inputs"][1], sketch);
}

TEST(History, MalformedHistoryIsAnInputError) {
  Document mesh = to_document(tests::cube(1));
  for (const Json& bad :
       {Json(7), Json::array({7}), Json::array({Json::object()}),
        Json::array({{{"previous", Json::array({0})}}}), Json::array({{{"previous", Json::array({-1})}}})}) {
    mesh.metadata["history"] = bad;
    EXPECT_THROW(extend_history({&mesh}, {"hull", {}, Json::array()}), InputError) << bad;
  }
}

}  // namespace
}  // namespace partwise::io
