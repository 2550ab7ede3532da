#pragma once

#include <string>
#include <vector>

#include "io/json_reader.h"
#include "mapping/domains.h"

namespace partwise::io {

/// Point of a mesh in JSON: {"face": 7, "barycentric": [0.2, 0.3, 0.5]}.
Json to_json(const SurfacePoint& point);
SurfacePoint read_surface_point(const JsonReader& json, const TriMesh& mesh);

/// Landmarks known on two models: name, source point, target point.
Json to_json(const std::vector<MarkerPair>& markers);
std::vector<MarkerPair> read_marker_pairs(const JsonReader& json, const TriMesh& source,
                                          const TriMesh& target);

/// Unique, non-empty texts of the member `name` of each object in an array.
std::vector<std::string> read_names(const JsonReader& array);

}  // namespace partwise::io
