#include "io/sketch.h"

#include <gtest/gtest.h>

#include "error.h"

namespace partwise::io {
namespace {

/// The message with which parsing fails, or "" when it does not.
std::string complaint(const std::string& members) {
  try {
    parse_sketch(R"({"schema": "partwise/sketch-1", )" + members + "}");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

constexpr const char* kIdentity = "[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]";

TEST(Sketch, KnowsEveryFormOfStrokeMarkerAndAnchor) {
  const Sketch sketch = parse_sketch(std::string(R"({"schema": "partwise/sketch-1",
    "parts": [{"name": "a", "strokes": [{"vertices": [3, 1]}, {"points": [[0, 0.5, 1]]},
                {"screen": [[4, 5], [6, 7]], "camera": {"view": [1,2,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1],
                 "projection": )") + kIdentity +
                                     R"(, "viewport": [800, 600]}}]}, {"name": "b"}],
    "markers": [{"name": "v", "vertex": 7}, {"name": "p", "point": [1, 2, 3]},
                {"name": "f", "face": 2, "barycentric": [0.25, 0.25, 0.5000001]}],
    "anchors": [{"name": "top", "between": ["b", "a"], "vertex": 9}],
    "mesh": {"vertices": 10, "faces": 16}})");
  ASSERT_EQ(sketch.parts.size(), 2U);
  ASSERT_EQ(sketch.parts[0].strokes.size(), 3U);
  EXPECT_EQ(std::get<VertexStroke>(sketch.parts[0].strokes[0]).vertices, (std::vector<int>{3, 1}));
  EXPECT_EQ(std::get<PointStroke>(sketch.parts[0].strokes[1]).points[0], Vec3(0, 0.5, 1));
  const auto& screen = std::get<ScreenStroke>(sketch.parts[0].strokes[2]);
  EXPECT_EQ(screen.polyline[1], Eigen::Vector2d(6, 7));
  EXPECT_EQ(screen.camera.view(0, 1), 2);  // row by row
  EXPECT_EQ(screen.camera.height, 600);
  EXPECT_EQ(std::get<int>(sketch.markers[0].place), 7);
  EXPECT_EQ(std::get<Vec3>(sketch.markers[1].place), Vec3(1, 2, 3));
  EXPECT_DOUBLE_EQ(std::get<SurfacePoint>(sketch.markers[2].place).barycentric.sum(), 1);
  EXPECT_EQ(sketch.anchors[0].between[0], "b");
  EXPECT_EQ(sketch.mesh->facets, 16);
}

TEST(Sketch, IsWrittenAsItIsRead) {
  const Json written = Json::parse(std::string(R"({"schema": "partwise/sketch-1", "comment": "mine",
    "parts": [{"name": "a", "strokes": [{"vertices": [3, 1]}, {"points": [[0.0, 0.1, 1.0]]},
                {"screen": [[4.0, 5.0], [6.0, 7.0]], "camera": {"view": [1.0,2.0,0.0,0.0, 0.0,1.0,0.0,0.0,
                 0.0,0.0,1.0,0.0, 0.0,0.0,0.0,1.0], "projection": [1.0,0.0,0.0,0.0, 0.0,1.0,0.0,0.0,
                 0.0,0.0,1.0,0.0, 0.0,0.0,0.0,1.0], "viewport": [800.0, 600.0]}}]}, {"name": "b", "strokes": []}],
    "markers": [{"name": "v", "vertex": 7}, {"name": "p", "point": [1.0, 2.0, 3.0]},
                {"name": "f", "face": 2, "barycentric": [0.25, 0.25, 0.5]}],
    "anchors": [{"name": "top", "between": ["b", "a"], "vertex": 9}],
    "mesh": {"vertices": 10, "faces": 16}})"));
  EXPECT_EQ(to_json(parse_sketch(written), "mine"), written);
  const Json empty = {{"schema", "partwise/sketch-1"}, {"parts", Json::array()}};
  EXPECT_EQ(to_json(Sketch(), ""), empty);
}

TEST(Sketch, MayBeEmpty) {
  EXPECT_TRUE(parse_sketch(std::string(R"({"schema": "partwise/sketch-1"})")).parts.empty());
}

TEST(Sketch, ComplaintsNamePartStrokeAndEntry) {
  EXPECT_EQ(
      complaint(R"("parts": [{"name": "head", "strokes": [{"vertices": [1]}, {"vertices": [2, -3]}]}])"),
      "part 'head', stroke 1, entry 1: -3 is no 0-based index");
  EXPECT_EQ(complaint(R"("parts": [{"name": "head", "strokes": [{"vertices": [1.5]}]}])"),
            "part 'head', stroke 0, entry 0: expected a 0-based index, got 1.5");
  EXPECT_EQ(complaint(R"("parts": [{"name": "head", "strokes": [{"points": [[1, 2]]}]}])"),
            "part 'head', stroke 0, entry 0: expected 3 numbers");
  EXPECT_EQ(complaint(R"("parts": [{"name": "head", "strokes": [{"vertices": []}]}])"),
            "part 'head', stroke 0: 'vertices' is empty");
  EXPECT_EQ(
      complaint(R"("parts": [{"name": "head", "strokes": [{"vertices": [1], "points": [[1, 2, 3]]}]}])"),
      "part 'head', stroke 0: give exactly one of 'vertices', 'points', 'screen'");
  EXPECT_EQ(complaint(R"("parts": [{"strokes": []}])"), "part 0: 'name' is missing");
  EXPECT_EQ(complaint(R"("parts": [{"name": "a", "strokes": [{"vertices": [99999999999]}]}])"),
            "part 'a', stroke 0, entry 0: 99999999999 is no 0-based index");
}

TEST(Sketch, RefusesNamesUsedTwice) {
  EXPECT_EQ(complaint(R"("parts": [{"name": "a"}, {"name": "a"}])"),
            "part 1: the name 'a' is used twice; names must be unique");
  EXPECT_EQ(complaint(R"("markers": [{"name": "m", "vertex": 1}, {"name": "m", "vertex": 2}])"),
            "marker 1: the name 'm' is used twice; names must be unique");
}

TEST(Sketch, RefusesBarycentricCoordinatesThatDoNotSumToOne) {
  EXPECT_EQ(complaint(R"("markers": [{"name": "m", "face": 1, "barycentric": [0.5, 0.5, 0.5]}])"),
            "marker 'm': barycentric coordinates must not be negative and must sum to 1, got [0.5,0.5,0.5]");
  EXPECT_NE(complaint(R"("markers": [{"name": "m", "face": 1, "barycentric": [-0.5, 0.5, 1]}])"), "");
}

TEST(Sketch, RefusesAnchorsBetweenUnknownOrEqualParts) {
  EXPECT_EQ(complaint(R"("parts": [{"name": "a"}],
                         "anchors": [{"name": "t", "between": ["a", "tial"], "vertex": 1}])"),
            "anchor 't': there is no part 'tial'; 'between' must name parts of this sketch");
  EXPECT_EQ(complaint(R"("parts": [{"name": "a"}],
                         "anchors": [{"name": "t", "between": ["a", "a"], "vertex": 1}])"),
            "anchor 't': 'between' must name two different parts");
}

TEST(Sketch, RefusesCamerasThatCannotBeInverted) {
  const std::string flat = "[1,0,0,0, 0,1,0,0, 0,0,0,0, 0,0,0,1]";
  auto with = [&](const std::string& view, const char* viewport) {
    return complaint(R"("parts": [{"name": "a", "strokes": [{"screen": [[1, 2]], "camera": {"view": )" +
                     view + R"(, "projection": )" + kIdentity + R"(, "viewport": )" + viewport + "}}]}]");
  };
  EXPECT_EQ(with(kIdentity, "[8, 6]"), "");
  EXPECT_EQ(
      with(flat, "[8, 6]"),
      "part 'a', stroke 0, camera: projection * view cannot be inverted; give both matrices row by row");
  EXPECT_NE(with(kIdentity, "[0, 6]").find("viewport"), std::string::npos);
}

TEST(Sketch, RefusesOtherSchemasMisspeltMembersAndBrokenJson) {
  EXPECT_THROW(parse_sketch(std::string(R"({"schema": "partwise/sketch-2"})")), InputError);
  EXPECT_NE(complaint(R"("prats": [])"), "");
  EXPECT_NE(complaint(R"("parts": [)").find("this is not JSON"), std::string::npos);
  EXPECT_THROW(read_sketch("/no/such/sketch.json"), IoError);
}

}  // namespace
}  // namespace partwise::io
