#include <array>
#include <cmath>
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

/// 0-based vertex of an OBJ corner "7", "7/1", "7//3", "7/1/3" or "-1" (the last vertex so far).
int obj_corner(std::string_view word, std::size_t vertices, const ByteSource& source) {
  const std::string_view number = word.substr(0, word.find('/'));
  int index = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), index);
  if (error != std::errc() || end != number.data() + number.size() || index == 0) {
    fail(source, "\"" + std::string(word.substr(0, 40)) + "\" is no vertex: they count from 1");
  }
  const long absolute = index > 0 ? index - 1L : static_cast<long>(vertices) + index;
  if (absolute < 0) fail(source, "vertex " + std::to_string(index) + " is before the first");
  return static_cast<int>(absolute);
}

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
        corners.push_back(obj_corner(word, builder.vertex_count(), source));
      }
      builder.polygon(corners, "line " + std::to_string(source.line_number()));
    } else if (!keyword.empty()) {
      if (line.find('\0') != std::string::npos || keyword.size() > 20)
        fail(source, "is no line of an OBJ file");
      if (ignored.size() < 20) ignored.insert("OBJ lines \"" + std::string(keyword) + "\"");
    }
  }
  ImportedMesh mesh = builder.finished();
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
