#pragma once

#include <array>
#include <charconv>
#include <string>
#include <string_view>
#include <vector>

#include "io/mesh_files.h"

namespace partwise::io {

/// Words of a line, from left to right.
class Words {
 public:
  explicit Words(std::string_view line) : rest_(line) {}
  /// The next word; empty at the end.
  std::string_view next();
  /// The next word as a number; false when there is none or it is no such number.
  template <class T>
  bool number(T& value) {
    std::string_view word = next();
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return !word.empty() && error == std::errc() && end == word.data() + word.size();
  }

 private:
  std::string_view rest_;
};

/// Collects polygons and cuts those with more than three corners.
class PolygonBuilder {
 public:
  void vertex(const Vec3& position) { mesh_.points.push_back(position); }
  std::size_t vertex_count() const { return mesh_.points.size(); }

  /// `place` names the polygon in messages ("line 7"). Corners may be vertices that only follow later.
  void polygon(const std::vector<int>& corners, const std::string& place);
  void triangle(const Facet& facet) {
    mesh_.facets.push_back(facet);
    file_corners_.push_back({corner_count_, corner_count_ + 1, corner_count_ + 2});
    corner_count_ += 3;
  }

  /// Per facet: which corners of the file's polygons its own are, counted through the whole file in the order
  /// that they were given in. \pre finished
  const std::vector<std::array<long, 3>>& file_corners() const { return file_corners_; }

  /// Cuts the polygons; facets keep the order of the file. \throws InputError for corners out of range of a
  /// polygon that must be cut (those of triangles are left to the mesh's validation).
  ImportedMesh finished();

 private:
  struct Polygon {
    std::size_t before;  ///< facets that precede it
    std::vector<int> corners;
    std::string place;
    long first_corner;  ///< its number in the file
  };
  ImportedMesh mesh_;
  std::vector<Polygon> polygons_;
  std::vector<std::array<long, 3>> file_corners_;
  long corner_count_ = 0;
};

}  // namespace partwise::io
