#include <utility>

#include "io/landmark_facts.h"
#include "io/sketch.h"

namespace partwise::io {
namespace {

template <class Vectors>
Json rows(const Vectors& vectors) {
  Json result = Json::array();
  for (const auto& v : vectors) result.push_back(std::vector<double>(v.begin(), v.end()));
  return result;
}

/// Row by row.
Json matrix(const Eigen::Matrix4d& m) {
  Json numbers = Json::array();
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) numbers.push_back(m(row, column));
  }
  return numbers;
}

Json to_json(const Stroke& stroke) {
  if (const auto* given = std::get_if<VertexStroke>(&stroke)) return {{"vertices", given->vertices}};
  if (const auto* near = std::get_if<PointStroke>(&stroke)) return {{"points", rows(near->points)}};
  const auto& drawn = std::get<ScreenStroke>(stroke);
  return {{"screen", rows(drawn.polyline)},
          {"camera",
           {{"view", matrix(drawn.camera.view)},
            {"projection", matrix(drawn.camera.projection)},
            {"viewport", {drawn.camera.width, drawn.camera.height}}}}};
}

Json to_json(const Place& place) {
  if (const int* vertex = std::get_if<int>(&place)) return {{"vertex", *vertex}};
  if (const Vec3* point = std::get_if<Vec3>(&place)) return {{"point", {point->x(), point->y(), point->z()}}};
  return io::to_json(std::get<SurfacePoint>(place));
}

}  // namespace

Json to_json(const Sketch& sketch, const std::string& comment) {
  Json json{{"schema", "partwise/sketch-1"}, {"parts", Json::array()}};
  if (!comment.empty()) json["comment"] = comment;
  if (sketch.mesh) json["mesh"] = {{"vertices", sketch.mesh->vertices}, {"faces", sketch.mesh->facets}};
  for (const SketchedPart& part : sketch.parts) {
    Json strokes = Json::array();
    for (const Stroke& stroke : part.strokes) strokes.push_back(to_json(stroke));
    json["parts"].push_back({{"name", part.name}, {"strokes", std::move(strokes)}});
  }
  for (const SketchedMarker& marker : sketch.markers) {
    Json item = to_json(marker.place);
    item["name"] = marker.name;
    json["markers"].push_back(std::move(item));
  }
  for (const SketchedAnchor& anchor : sketch.anchors) {
    Json item = to_json(anchor.place);
    item["name"] = anchor.name;
    item["between"] = anchor.between;
    json["anchors"].push_back(std::move(item));
  }
  return json;
}

}  // namespace partwise::io
