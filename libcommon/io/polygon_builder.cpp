#include "io/polygon_builder.h"

#include <algorithm>
#include <utility>

#include "error.h"
#include "mesh/triangulate.h"

namespace partwise::io {
namespace {

constexpr std::size_t kMostCorners = 1000;

/// The first place of a corner that occurs.
long index_in(const std::vector<int>& corners, int vertex) {
  return std::find(corners.begin(), corners.end(), vertex) - corners.begin();
}

}  // namespace

std::string_view Words::next() {
  const std::string_view kSpace = " \t\r";
  const std::size_t begin = std::min(rest_.find_first_not_of(kSpace), rest_.size());
  const std::size_t end = std::min(rest_.find_first_of(kSpace, begin), rest_.size());
  const std::string_view word = rest_.substr(begin, end - begin);
  rest_.remove_prefix(end);
  return word;
}

void PolygonBuilder::polygon(const std::vector<int>& corners, const std::string& place) {
  if (corners.size() < 3) throw InputError(place + ": a facet needs three corners at the least");
  if (corners.size() > kMostCorners) {
    throw InputError(place + ": a facet has " + std::to_string(corners.size()) +
                     " corners: cut it into triangles before");
  }
  if (corners.size() == 3) {
    triangle({corners[0], corners[1], corners[2]});
  } else {
    polygons_.push_back({mesh_.facets.size(), corners, place, corner_count_});
    corner_count_ += static_cast<long>(corners.size());
  }
}

ImportedMesh PolygonBuilder::finished() {
  Facets facets;
  std::vector<std::array<long, 3>> file_corners;
  facets.reserve(mesh_.facets.size() + 2 * polygons_.size());
  std::size_t taken = 0;
  const auto take_triangles = [&](std::size_t end) {
    for (; taken < end; ++taken) {
      facets.push_back(mesh_.facets[taken]);
      file_corners.push_back(file_corners_[taken]);
    }
  };
  for (const Polygon& polygon : polygons_) {
    take_triangles(polygon.before);
    for (const int corner : polygon.corners) {
      if (corner < 0 || corner >= static_cast<long>(mesh_.points.size())) {
        throw InputError(polygon.place + ": names vertex " + std::to_string(corner) + " (0-based) of " +
                         std::to_string(mesh_.points.size()));
      }
    }
    for (const Facet& facet : triangulate_polygon(mesh_.points, polygon.corners)) {
      facets.push_back(facet);
      std::array<long, 3>& corners = file_corners.emplace_back();
      for (int i = 0; i < 3; ++i) corners[i] = polygon.first_corner + index_in(polygon.corners, facet[i]);
    }
  }
  take_triangles(mesh_.facets.size());
  mesh_.facets = std::move(facets);
  file_corners_ = std::move(file_corners);
  mesh_.polygons = static_cast<long>(polygons_.size());
  return std::move(mesh_);
}

}  // namespace partwise::io
