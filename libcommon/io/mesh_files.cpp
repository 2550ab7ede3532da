#include "io/mesh_files.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <set>
#include <utility>

#include "error.h"
#include "io/pending_file.h"
#include "io/polygon_builder.h"
#include "io/texture_columns.h"

namespace partwise::io {
namespace {

std::string ending(const std::string& path) {
  std::string text = std::filesystem::path(path).extension().string();
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

void append(std::string& text, const char* value) {
  text += value;
}

template <class Number>
void append(std::string& text, Number value) {
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

/// Gathers text and writes it in large pieces.
class TextWriter {
 public:
  explicit TextWriter(std::ostream& out) : out_(out) {}
  ~TextWriter() { flush(); }
  TextWriter(const TextWriter&) = delete;
  TextWriter& operator=(const TextWriter&) = delete;

  /// Strings as they are, numbers so that they read back equal.
  template <class... Values>
  void write(const Values&... values) {
    (append(text_, values), ...);
    if (text_.size() > 1 << 20) flush();
  }

 private:
  void flush() {
    out_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
    text_.clear();
  }

  std::ostream& out_;
  std::string text_;
};

void write_off(std::ostream& out, const Points& points, const Facets& facets) {
  TextWriter text(out);
  text.write("OFF\n", points.size(), " ", facets.size(), " 0\n");
  for (const Vec3& p : points) text.write(p.x(), " ", p.y(), " ", p.z(), "\n");
  for (const auto& [a, b, c] : facets) text.write("3 ", a, " ", b, " ", c, "\n");
}

void write_obj(std::ostream& out, const Points& points, const Facets& facets) {
  TextWriter text(out);
  for (const Vec3& p : points) text.write("v ", p.x(), " ", p.y(), " ", p.z(), "\n");
  for (const auto& [a, b, c] : facets) text.write("f ", a + 1, " ", b + 1, " ", c + 1, "\n");
}

void write_obj(std::ostream& out, const Points& points, const Facets& facets, const TextureCorners& texture) {
  const SeamVertices split = split_at_seams(static_cast<int>(points.size()), facets, texture);
  TextWriter text(out);
  for (const Vec3& p : points) text.write("v ", p.x(), " ", p.y(), " ", p.z(), "\n");
  for (const Eigen::Vector2d& place : split.places) {
    text.write("vt ", static_cast<float>(place.x()), " ", static_cast<float>(place.y()), "\n");
  }
  for (std::size_t f = 0; f < facets.size(); ++f) {
    if (!texture.images.empty() && (f == 0 || texture.images[f] != texture.images[f - 1])) {
      text.write("usemtl image_", texture.images[f], "\n");
    }
    text.write("f");
    for (int i = 0; i < 3; ++i) text.write(" ", facets[f][i] + 1, "/", split.facets[f][i] + 1);
    text.write("\n");
  }
}

void append_floats(std::string& bytes, const Vec3& vector) {
  for (const double coordinate : vector) {
    const auto value = static_cast<float>(coordinate);
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(raw, sizeof value);
  }
}

/// \pre a little-endian machine
void write_stl(std::ostream& out, const Points& points, const Facets& facets) {
  std::string bytes(80, ' ');
  const auto count = static_cast<std::uint32_t>(facets.size());
  char raw[sizeof count];
  std::memcpy(raw, &count, sizeof count);
  bytes.append(raw, sizeof count);
  for (const auto& [a, b, c] : facets) {
    append_floats(bytes, (points[b] - points[a]).cross(points[c] - points[a]).stableNormalized());
    for (const int vertex : {a, b, c}) append_floats(bytes, points[vertex]);
    bytes.append(2, '\0');
  }
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

void write_plain_ply(std::ostream& out, const Points& points, const Facets& facets,
                     const std::optional<TextureCorners>& texture) {
  PlyTables tables;
  Element vertices{"vertex", points.size(), {}};
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (const Vec3& point : points) values.push_back(point[axis]);
    vertices.properties.push_back(scalar_column(std::string(1, "xyz"[axis]), std::move(values)));
  }
  std::vector<int> corners;
  for (const Facet& facet : facets) corners.insert(corners.end(), facet.begin(), facet.end());
  tables.elements = {std::move(vertices),
                     {"face", facets.size(), {list_column("vertex_indices", std::move(corners), 3)}}};
  if (texture) {
    for (Property& column : texture_columns(*texture)) {
      tables.elements[1].properties.push_back(std::move(column));
    }
  }
  write_ply(out, tables);
}

/// Texture coordinates of a PLY's polygons, given to the triangles that they were cut into.
/// \param file_corners see PolygonBuilder
void put_texture(const PlyTables& tables, const Property& corners,
                 const std::vector<std::array<long, 3>>& file_corners, ImportedMesh& mesh) {
  const Element& faces = *tables.find("face");
  const Property* given = faces.find("texcoord");
  if (!given || !given->is_list) return;
  std::vector<int> rows;  // per corner of the file
  for (std::size_t row = 0; row < faces.size; ++row) {
    const std::size_t count = corners.offsets[row + 1] - corners.offsets[row];
    const std::size_t numbers = given->offsets[row + 1] - given->offsets[row];
    if (numbers != 2 * count) {
      throw InputError("element face, row " + std::to_string(row) + ", property texcoord: has " +
                       std::to_string(numbers) + " numbers for " + std::to_string(count) +
                       " corners, which need two each");
    }
    rows.insert(rows.end(), count, static_cast<int>(row));
  }
  const std::vector<double> places = numbers_of(given->values);
  const Property* images = faces.find("texnumber");
  const std::vector<int> numbers =
      images && !images->is_list ? column<int>(tables, "face", "texnumber") : std::vector<int>{};
  TextureCorners texture;
  for (const std::array<long, 3>& facet : file_corners) {
    std::array<double, 6>& of_facet = texture.places.emplace_back();
    for (int i = 0; i < 6; ++i) of_facet[i] = places[2 * facet[i / 2] + i % 2];
    if (!numbers.empty()) texture.images.push_back(numbers[rows[facet[0]]]);
  }
  mesh.texture = std::move(texture);
}

const Property& corner_lists(const Element& faces) {
  for (const char* name : {"vertex_indices", "vertex_index"}) {
    const Property* found = faces.find(name);
    if (found && found->is_list) return *found;
  }
  throw InputError("element face has no list vertex_indices");
}

}  // namespace

bool is_foreign_mesh_file(const std::string& path) {
  const std::string end = ending(path);
  return end == ".obj" || end == ".off" || end == ".stl";
}

ImportedMesh import_mesh(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) throw IoError(path + ": is a folder: give a file");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw IoError(path + ": cannot be opened: " + std::strerror(errno ? errno : EIO));
  try {
    if (ending(path) == ".obj") return read_obj(file);
    if (ending(path) == ".off") return read_off(file);
    if (ending(path) == ".stl") return read_stl(file);
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
  throw UsageError(path + ": must end in .obj, .off, .stl or .ply");
}

ImportedMesh import_ply(const PlyTables& tables) {
  PolygonBuilder builder;
  const auto x = column<double>(tables, "vertex", "x");
  const auto y = column<double>(tables, "vertex", "y");
  const auto z = column<double>(tables, "vertex", "z");
  for (std::size_t v = 0; v < x.size(); ++v) builder.vertex({x[v], y[v], z[v]});
  const Element* faces = tables.find("face");
  if (!faces) throw InputError("element face is missing: is this a mesh, or a cloud of points?");
  const Property& lists = corner_lists(*faces);
  std::visit(
      [&](const auto& values) {
        std::vector<int> corners;
        for (std::size_t row = 0; row < faces->size; ++row) {
          corners.clear();
          for (std::size_t i = lists.offsets[row]; i < lists.offsets[row + 1]; ++i) {
            const auto corner = static_cast<double>(values[i]);
            // Whatever is no index at all becomes one that validation refuses.
            corners.push_back(corner >= 0 && corner < 2147483647.0 ? static_cast<int>(corner) : -1);
          }
          builder.polygon(corners, "element face, row " + std::to_string(row));
        }
      },
      lists.values);
  ImportedMesh mesh = builder.finished();
  put_texture(tables, lists, builder.file_corners(), mesh);
  for (const Element& element : tables.elements) {
    for (const Property& property : element.properties) {
      const bool is_texture = mesh.texture && element.name == "face" &&
                              (property.name == "texcoord" || property.name == "texnumber");
      const bool used = &property == &lists || is_texture ||
                        (element.name == "vertex" && property.name.size() == 1 && property.name >= "x" &&
                         property.name <= "z");
      if (!used) mesh.ignored.push_back(element.name + " property " + property.name);
    }
  }
  return mesh;
}

void export_mesh(const std::string& path, const Points& points, const Facets& facets, bool overwrite,
                 const std::optional<TextureCorners>& texture) {
  const std::string end = ending(path);
  if (end != ".obj" && end != ".off" && end != ".stl" && end != ".ply" && path != "-") {
    throw UsageError(path + ": must end in .obj, .off, .stl or .ply");
  }
  write_file(path, overwrite, [&](std::ostream& out) {
    if (end == ".obj" && texture) {
      write_obj(out, points, facets, *texture);
    } else if (end == ".obj") {
      write_obj(out, points, facets);
    } else if (end == ".off") {
      write_off(out, points, facets);
    } else if (end == ".stl") {
      write_stl(out, points, facets);
    } else {
      write_plain_ply(out, points, facets, texture);
    }
  });
}

}  // namespace partwise::io
