#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "error.h"
#include "io/byte_source.h"
#include "io/polygon_builder.h"

namespace partwise::io {
namespace {

constexpr std::size_t kLongestLine = std::size_t{1} << 20;

[[noreturn]] void fail(const ByteSource& source, const std::string& what) {
  throw InputError("line " + std::to_string(source.line_number()) + ": " + what);
}

Vec3 read_position(Words& words, const ByteSource& source) {
  Vec3 position;
  for (double& coordinate : position) {
    if (!words.number(coordinate)) fail(source, "a vertex needs three numbers");
  }
  return position;
}

/// A number of an OBJ corner, 0-based: OBJ counts from 1, or back from the last so far (-1).
/// \param what it counts, for messages; `count` of them so far
int obj_index(std::string_view number, const std::string& what, std::size_t count, const ByteSource& source) {
  int index = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), index);
  if (error != std::errc() || end != number.data() + number.size() || index == 0) {
    fail(source, "\"" + std::string(number.substr(0, 40)) + "\" is no " + what + ": they count from 1");
  }
  const long absolute = index > 0 ? index - 1L : static_cast<long>(count) + index;
  if (absolute < 0) fail(source, what + " " + std::to_string(index) + " is before the first");
  return static_cast<int>(absolute);
}

/// What an OBJ file says of texture: collected in the order of the file, as corners may name what only
/// follows.
class ObjTexture {
 public:
  void add_place(Words& words, const ByteSource& source) {
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    if (!words.number(place[0]) || !std::isfinite(place[0])) fail(source, "vt needs a number");
    if (Words rest = words; !rest.next().empty() && (!words.number(place[1]) || !std::isfinite(place[1]))) {
      fail(source, "the second number of vt is none");
    }
    places_.push_back(place);
  }

  void use_material(std::string_view name) {
    material_ = materials_.try_emplace(std::string(name), static_cast<int>(materials_.size())).first->second;
  }

  /// \param word "7", "7/1", "7//3" or "7/1/3"
  void add_corner(std::string_view word, const ByteSource& source) {
    const std::size_t slash = word.find('/');
    const std::string_view rest = slash == std::string_view::npos ? "" : word.substr(slash + 1);
    const std::string_view number = rest.substr(0, rest.find('/'));
    const int place = number.empty() ? -1 : obj_index(number, "texture coordinate", places_.size(), source);
    corners_.push_back({place, material_});
    is_used_ = is_used_ || place >= 0;
  }

  /// Gives the mesh the texture of the corners that its facets have.
  void put_on(ImportedMesh& mesh, const std::vector<std::array<long, 3>>& file_corners) const {
    if (!is_used_) return;
    TextureCorners texture;
    std::set<int> images;
    for (std::size_t f = 0; f < file_corners.size(); ++f) {
      std::array<double, 6>& of_facet = texture.places.emplace_back();
      bool is_bare = false;
      for (int i = 0; i < 3; ++i) {
        const Eigen::Vector2d place = place_of(corners_[file_corners[f][i]].place, f);
        is_bare = is_bare || corners_[file_corners[f][i]].place < 0;
        of_facet[2 * i] = place.x();
        of_facet[2 * i + 1] = place.y();
      }
      if (is_bare) ++mesh.bare_facets;
      texture.images.push_back(corners_[file_corners[f][0]].material);
      images.insert(texture.images.back());
    }
    if (images.size() == 1) texture.images.clear();
    mesh.texture = std::move(texture);
  }

 private:
  struct Corner {
    int place, material;
  };

  Eigen::Vector2d place_of(int index, std::size_t facet) const {
    if (index < 0) return Eigen::Vector2d::Zero();
    if (index < static_cast<long>(places_.size())) return places_[index];
    throw InputError("facet " + std::to_string(facet) + " names texture coordinate " +
                     std::to_string(index + 1) + " of " + std::to_string(places_.size()) +
                     ": write the file with its vt lines, or without texture coordinates");
  }

  std::vector<Eigen::Vector2d> places_;
  std::map<std::string, int> materials_;
  int material_ = 0;
  std::vector<Corner> corners_;
  bool is_used_ = false;
};

/// The next line of an OFF file that says something, without its comment.
bool next_off_line(ByteSource& source, std::string_view& line) {
  while (source.next_line(line, kLongestLine)) {
    line = line.substr(0, line.find('#'));
    if (line.find_first_not_of(" \t\r") != std::string_view::npos) return true;
  }
  return false;
}

/// Vertex and facet counts, which may stand in the line of the word OFF.
std::array<long, 2> read_off_header(ByteSource& source) {
  std::string_view line;
  if (!next_off_line(source, line)) throw InputError("there is no data: is the file empty?");
  Words words(line);
  const std::string_view keyword = words.next();
  if (keyword != "OFF" && keyword != "COFF" && keyword != "NOFF" && keyword != "STOFF" &&
      keyword != "CNOFF") {
    fail(source, "must begin with OFF (3 coordinates a vertex)");
  }
  std::array<long, 2> counts{};
  Words probe = words;
  if (probe.next().empty()) {
    if (!next_off_line(source, line)) fail(source, "the counts of vertices and facets are missing");
    words = Words(line);
  }
  if (!words.number(counts[0]) || !words.number(counts[1]) || counts[0] < 0 || counts[1] < 0) {
    fail(source, "must give the numbers of vertices and facets (text, not binary)");
  }
  return counts;
}

}  // namespace

ImportedMesh read_obj(std::istream& in) {
  ByteSource source(in);
  PolygonBuilder builder;
  std::set<std::string> ignored;
  std::vector<int> corners;
  ObjTexture texture;
  std::string_view part;
  std::string line;
  while (source.next_line(part, kLongestLine)) {
    line = part;
    while (!line.empty() && line.back() == '\\' && source.next_line(part, kLongestLine)) {
      line.back() = ' ';
      line += part;
    }
    Words words(std::string_view(line).substr(0, line.find('#')));
    const std::string_view keyword = words.next();
    if (keyword == "v") {
      builder.vertex(read_position(words, source));
    } else if (keyword == "f") {
      corners.clear();
      for (auto word = words.next(); !word.empty(); word = words.next()) {
        corners.push_back(
            obj_index(word.substr(0, word.find('/')), "vertex", builder.vertex_count(), source));
        texture.add_corner(word, source);
      }
      builder.polygon(corners, "line " + std::to_string(source.line_number()));
    } else if (keyword == "vt") {
      texture.add_place(words, source);
    } else if (keyword == "usemtl") {
      texture.use_material(words.next());
    } else if (!keyword.empty()) {
      if (line.find('\0') != std::string::npos || keyword.size() > 20)
        fail(source, "is no line of an OBJ file");
      if (ignored.size() < 20) ignored.insert("OBJ lines \"" + std::string(keyword) + "\"");
    }
  }
  ImportedMesh mesh = builder.finished();
  texture.put_on(mesh, builder.file_corners());
  mesh.ignored.assign(ignored.begin(), ignored.end());
  return mesh;
}

ImportedMesh read_off(std::istream& in) {
  ByteSource source(in);
  PolygonBuilder builder;
  const auto [vertices, facets] = read_off_header(source);
  std::string_view line;
  for (long v = 0; v < vertices; ++v) {
    if (!next_off_line(source, line)) {
      throw InputError("the file ends at vertex " + std::to_string(v) + " of " + std::to_string(vertices) +
                       ": it is truncated");
    }
    Words words(line);
    builder.vertex(read_position(words, source));
  }
  std::vector<int> corners;
  for (long f = 0; f < facets; ++f) {
    if (!next_off_line(source, line)) {
      throw InputError("the file ends at facet " + std::to_string(f) + " of " + std::to_string(facets) +
                       ": it is truncated");
    }
    Words words(line);
    long count = 0;
    if (!words.number(count) || count < 0) fail(source, "a facet begins with its number of corners");
    corners.clear();
    for (long i = 0; i < count; ++i) {
      int corner = 0;
      if (!words.number(corner)) fail(source, "the facet names fewer corners than it says");
      corners.push_back(corner);
    }
    builder.polygon(corners, "line " + std::to_string(source.line_number()));
  }
  if (next_off_line(source, line)) fail(source, "follows after the last facet: correct the counts");
  return builder.finished();
}

}  // namespace partwise::io
