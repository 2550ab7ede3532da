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

namespace partwise::io {
namespace {

std::string ending(const std::string& path) {
  std::string text = std::filesystem::path(path).extension().string();
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

void append(std::string& text, double value) {
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

void append(std::string& text, int value) {
  char digits[16];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

/// OBJ and OFF differ in their headers, in what begins a line and in where counting begins.
void write_text(std::ostream& out, const Points& points, const Facets& facets, bool obj) {
  std::string text =
      obj ? "" : "OFF\n" + std::to_string(points.size()) + " " + std::to_string(facets.size()) + " 0\n";
  const auto flush = [&](std::size_t most) {
    if (text.size() < most) return;
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
    text.clear();
  };
  for (const Vec3& point : points) {
    if (obj) text += "v ";
    for (int axis = 0; axis < 3; ++axis) {
      append(text, point[axis]);
      text += axis < 2 ? ' ' : '\n';
    }
    flush(1 << 20);
  }
  for (const Facet& facet : facets) {
    text += obj ? "f" : "3";
    for (const int vertex : facet) {
      text += ' ';
      append(text, vertex + (obj ? 1 : 0));
    }
    text += '\n';
    flush(1 << 20);
  }
  flush(0);
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

void write_plain_ply(std::ostream& out, const Points& points, const Facets& facets) {
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
  write_ply(out, tables);
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
  for (const Element& element : tables.elements) {
    for (const Property& property : element.properties) {
      const bool used = &property == &lists || (element.name == "vertex" && property.name.size() == 1 &&
                                                property.name >= "x" && property.name <= "z");
      if (!used) mesh.ignored.push_back(element.name + " property " + property.name);
    }
  }
  return mesh;
}

void export_mesh(const std::string& path, const Points& points, const Facets& facets, bool overwrite) {
  const std::string end = ending(path);
  if (end != ".obj" && end != ".off" && end != ".stl" && end != ".ply" && path != "-") {
    throw UsageError(path + ": must end in .obj, .off, .stl or .ply");
  }
  write_file(path, overwrite, [&](std::ostream& out) {
    if (end == ".obj" || end == ".off") {
      write_text(out, points, facets, end == ".obj");
    } else if (end == ".stl") {
      write_stl(out, points, facets);
    } else {
      write_plain_ply(out, points, facets);
    }
  });
}

}  // namespace partwise::io
