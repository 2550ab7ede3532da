#include "io/sketch.h"

#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

#include "error.h"
#include "io/schema_validation.h"

namespace partwise::io {
namespace {

constexpr const char* kSchema = "partwise/sketch-1";

[[noreturn]] void fail(const std::string& where, const std::string& what) {
  throw InputError(where + ": " + what);
}

const Json& member(const Json& object, const char* key, const std::string& where) {
  if (!object.is_object()) fail(where, "expected an object");
  const auto found = object.find(key);
  if (found == object.end()) fail(where, std::string("'") + key + "' is missing");
  return *found;
}

const Json& array(const Json& json, const std::string& where) {
  if (!json.is_array()) fail(where, "expected an array");
  return json;
}

/// The array under `key`, or an empty one when there is none.
const Json& optional_array(const Json& object, const char* key) {
  static const Json empty = Json::array();
  const auto found = object.find(key);
  return found == object.end() ? empty : array(*found, std::string("'") + key + "'");
}

double number(const Json& json, const std::string& where) {
  if (!json.is_number()) fail(where, "expected a number, got " + json.dump());
  const double value = json.get<double>();
  if (!std::isfinite(value)) fail(where, "the number is not finite");
  return value;
}

int index(const Json& json, const std::string& where) {
  if (!json.is_number_integer()) fail(where, "expected a 0-based index, got " + json.dump());
  const bool fits = json.is_number_unsigned() ? json.get<std::uint64_t>() <= std::numeric_limits<int>::max()
                                              : json.get<std::int64_t>() >= 0;
  if (!fits) fail(where, json.dump() + " is no 0-based index");
  return json.get<int>();
}

template <int N>
Eigen::Matrix<double, N, 1> vector(const Json& json, const std::string& where) {
  if (array(json, where).size() != N) fail(where, "expected " + std::to_string(N) + " numbers");
  Eigen::Matrix<double, N, 1> result;
  for (int i = 0; i < N; ++i) result[i] = number(json[i], where);
  return result;
}

std::string name(const Json& object, const std::string& where, std::set<std::string>& names) {
  const Json& json = member(object, "name", where);
  if (!json.is_string() || json.get<std::string>().empty()) fail(where, "'name' must be a non-empty text");
  if (!names.insert(json.get<std::string>()).second) {
    fail(where, "the name '" + json.get<std::string>() + "' is used twice; names must be unique");
  }
  return json.get<std::string>();
}

Camera camera(const Json& json, const std::string& where) {
  Camera result;
  // Read as column-major, hence transposed: the sketch stores rows.
  result.view = vector<16>(member(json, "view", where), where + ", view").reshaped(4, 4).transpose();
  result.projection =
      vector<16>(member(json, "projection", where), where + ", projection").reshaped(4, 4).transpose();
  const Eigen::Vector2d viewport = vector<2>(member(json, "viewport", where), where + ", viewport");
  result.width = viewport[0];
  result.height = viewport[1];
  if (!(viewport.minCoeff() > 0)) fail(where, "the viewport must have a positive width and height");
  if (!(result.projection * result.view).fullPivLu().isInvertible()) {
    fail(where, "projection * view cannot be inverted; give both matrices row by row");
  }
  return result;
}

/// Reads every entry of the array under `form`; there must be at least one.
template <class Read>
auto entries(const Json& json, const char* form, const std::string& where, Read read) {
  const Json& list = array(json[form], where + ", '" + form + "'");
  if (list.empty()) fail(where, std::string("'") + form + "' is empty");
  std::vector<decltype(read(list, where))> result;
  for (std::size_t i = 0; i < list.size(); ++i) {
    result.push_back(read(list[i], where + ", entry " + std::to_string(i)));
  }
  return result;
}

Stroke stroke(const Json& json, const std::string& where) {
  if (!json.is_object()) fail(where, "expected an object");
  if (json.contains("vertices") + json.contains("points") + json.contains("screen") != 1) {
    fail(where, "give exactly one of 'vertices', 'points', 'screen'");
  }
  if (json.contains("vertices")) return VertexStroke{entries(json, "vertices", where, index)};
  if (json.contains("points")) return PointStroke{entries(json, "points", where, vector<3>)};
  return ScreenStroke{entries(json, "screen", where, vector<2>),
                      camera(member(json, "camera", where), where + ", camera")};
}

Place place(const Json& json, const std::string& where) {
  const int forms = json.contains("vertex") + json.contains("point") + json.contains("face");
  if (forms != 1) fail(where, "give exactly one of 'vertex', 'point', 'face' (with 'barycentric')");
  if (json.contains("vertex")) return index(json["vertex"], where);
  if (json.contains("point")) return Vec3(vector<3>(json["point"], where));
  SurfacePoint point;
  point.facet = index(json["face"], where);
  point.barycentric = vector<3>(member(json, "barycentric", where), where + ", barycentric");
  if (point.barycentric.minCoeff() < 0 || std::abs(point.barycentric.sum() - 1) > 1e-6) {
    fail(where,
         "barycentric coordinates must not be negative and must sum to 1, got " + json["barycentric"].dump());
  }
  point.barycentric /= point.barycentric.sum();
  return point;
}

SketchedPart part(const Json& json, std::size_t number_of_part, std::set<std::string>& names) {
  SketchedPart result;
  result.name = name(json, "part " + std::to_string(number_of_part), names);
  const Json& strokes = optional_array(json, "strokes");
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    result.strokes.push_back(stroke(strokes[i], "part '" + result.name + "', stroke " + std::to_string(i)));
  }
  return result;
}

SketchedAnchor anchor(const Json& json, std::size_t number_of_anchor, std::set<std::string>& names,
                      const std::set<std::string>& part_names) {
  SketchedAnchor result;
  result.name = name(json, "anchor " + std::to_string(number_of_anchor), names);
  const std::string where = "anchor '" + result.name + "'";
  const Json& between = array(member(json, "between", where), where + ", 'between'");
  if (between.size() != 2 || !between[0].is_string() || !between[1].is_string() || between[0] == between[1]) {
    fail(where, "'between' must name two different parts");
  }
  for (int i = 0; i < 2; ++i) {
    result.between[i] = between[i].get<std::string>();
    if (!part_names.contains(result.between[i])) {
      fail(where, "there is no part '" + result.between[i] + "'; 'between' must name parts of this sketch");
    }
  }
  result.place = place(json, where);
  return result;
}

}  // namespace

Sketch parse_sketch(const Json& json) {
  if (!json.is_object() || json.value("schema", Json()) != kSchema) {
    fail("sketch", std::string("'schema' must be \"") + kSchema + "\"");
  }
  Sketch sketch;
  std::set<std::string> part_names, marker_names, anchor_names;
  const Json& parts = optional_array(json, "parts");
  for (std::size_t i = 0; i < parts.size(); ++i) sketch.parts.push_back(part(parts[i], i, part_names));
  const Json& markers = optional_array(json, "markers");
  for (std::size_t i = 0; i < markers.size(); ++i) {
    std::string marker_name = name(markers[i], "marker " + std::to_string(i), marker_names);
    const Place where = place(markers[i], "marker '" + marker_name + "'");
    sketch.markers.push_back({std::move(marker_name), where});
  }
  const Json& anchors = optional_array(json, "anchors");
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    sketch.anchors.push_back(anchor(anchors[i], i, anchor_names, part_names));
  }
  if (json.contains("mesh")) {
    sketch.mesh = SketchedMesh{index(member(json["mesh"], "vertices", "mesh"), "mesh, vertices"),
                               index(member(json["mesh"], "faces", "mesh"), "mesh, faces")};
  }
  validate_metadata(json);  // last: its paths say less than the names in the messages above
  return sketch;
}

Sketch parse_sketch(const std::string& text) {
  try {
    return parse_sketch(Json::parse(text));
  } catch (const Json::parse_error& error) {
    throw InputError(std::string("this is not JSON: ") + error.what());
  }
}

Sketch read_sketch(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw IoError(path + ": cannot open the sketch for reading; check name and permissions");
  const std::string text(std::istreambuf_iterator<char>(in), {});
  try {
    return parse_sketch(text);
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
}

}  // namespace partwise::io
