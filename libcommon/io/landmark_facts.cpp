#include "io/landmark_facts.h"

#include <cmath>
#include <set>

namespace partwise::io {

Json to_json(const SurfacePoint& point) {
  return {{"face", point.facet},
          {"barycentric", {point.barycentric[0], point.barycentric[1], point.barycentric[2]}}};
}

SurfacePoint read_surface_point(const JsonReader& json, const TriMesh& mesh) {
  SurfacePoint point;
  point.facet = json["face"].integer(0, mesh.facet_count() - 1);
  const JsonReader barycentric = json["barycentric"];
  const std::vector<JsonReader> items = barycentric.items();
  if (items.size() != 3) barycentric.fail("three numbers are expected here");
  for (int i = 0; i < 3; ++i) point.barycentric[i] = items[i].number();
  if (point.barycentric.minCoeff() < -1e-12 || !(std::abs(point.barycentric.sum() - 1) <= 1e-9)) {
    barycentric.fail("barycentric coordinates must not be negative and must add to 1");
  }
  return point;
}

Json to_json(const std::vector<MarkerPair>& markers) {
  Json result = Json::array();
  for (const MarkerPair& marker : markers) {
    result.push_back(
        {{"name", marker.name}, {"source", to_json(marker.source)}, {"target", to_json(marker.target)}});
  }
  return result;
}

std::vector<MarkerPair> read_marker_pairs(const JsonReader& json, const TriMesh& source,
                                          const TriMesh& target) {
  std::vector<MarkerPair> markers;
  for (const JsonReader& item : json.items()) {
    markers.push_back({item["name"].text(), read_surface_point(item["source"], source),
                       read_surface_point(item["target"], target)});
  }
  return markers;
}

std::vector<std::string> read_names(const JsonReader& array) {
  std::vector<std::string> names;
  std::set<std::string> seen;
  for (const JsonReader& item : array.items()) {
    const std::string name = item["name"].text();
    if (name.empty()) item["name"].fail("a name must not be empty");
    if (!seen.insert(name).second) item["name"].fail("the name '" + name + "' is given twice");
    names.push_back(name);
  }
  if (names.empty()) array.fail("at least one part is expected here");
  return names;
}

}  // namespace partwise::io
