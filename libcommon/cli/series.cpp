#include "cli/series.h"

#include <unistd.h>

#include <filesystem>

#include "error.h"
#include "io/carried_columns.h"
#include "io/gltf.h"
#include "io/pending_file.h"
#include "io/stage_documents.h"
#include "io/texture_columns.h"

namespace partwise::cli {
namespace {

std::string shown(const Facet& facet) {
  return "(" + std::to_string(facet[0]) + ", " + std::to_string(facet[1]) + ", " + std::to_string(facet[2]) +
         ")";
}

/// Columns of `vertex`, if all are there, as numbers by row.
std::vector<std::vector<double>> vertex_columns(const io::Document& document,
                                                const std::vector<std::string>& names) {
  const io::Element* vertices = document.tables.find("vertex");
  std::vector<std::vector<double>> columns;
  for (const std::string& name : names) {
    const io::Property* property = vertices ? vertices->find(name) : nullptr;
    if (!property || property->is_list) return {};
    columns.push_back(io::column<double>(document.tables, "vertex", name));
  }
  return columns;
}

/// Texture coordinates that vertices have, as Blender writes them, at the corners of facets.
std::optional<TextureCorners> vertex_texture(const io::Document& looks, const Facets& facets) {
  for (const std::vector<std::string>& names :
       {std::vector<std::string>{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}}) {
    const auto places = vertex_columns(looks, names);
    if (places.empty()) continue;
    TextureCorners texture;
    for (const auto& [a, b, c] : facets) {
      texture.places.push_back(
          {places[0][a], places[1][a], places[0][b], places[1][b], places[0][c], places[1][c]});
    }
    return texture;
  }
  return {};
}

void add_looks(io::ShapeAnimation& animation, const io::Document& looks) {
  const auto colours = vertex_columns(looks, {"red", "green", "blue"});
  const io::Element* vertices = looks.tables.find("vertex");
  if (!colours.empty() && vertices->find("red")->type() == io::ScalarType::uint8) {
    for (std::size_t v = 0; v < vertices->size; ++v) {
      animation.colours.push_back({static_cast<std::uint8_t>(colours[0][v]),
                                   static_cast<std::uint8_t>(colours[1][v]),
                                   static_cast<std::uint8_t>(colours[2][v])});
    }
  }
  animation.texture = io::read_texture(looks.tables);
  if (!animation.texture) animation.texture = vertex_texture(looks, animation.facets);
}

}  // namespace

io::PlyTables ModelInput::tables() const {
  if (document) return document->tables;
  io::PlyTables tables;
  tables.elements = {{"vertex", mesh.points().size(), {}}, {"face", mesh.facets().size(), {}}};
  if (texture) tables.elements[1].properties = io::texture_columns(*texture);
  return tables;
}

ModelInput read_model(Command& command, const std::string& path) {
  if (io::is_foreign_mesh_file(path)) {
    io::ImportedMesh imported = command.import_mesh(path);
    return command.about(path, [&] {
      return ModelInput{TriMesh(std::move(imported.points), std::move(imported.facets)), std::nullopt,
                        std::move(imported.texture)};
    });
  }
  io::Document document = command.read(path, {});
  return command.about(path, [&] {
    TriMesh mesh = io::read_mesh(document);
    return ModelInput{std::move(mesh), std::move(document), std::nullopt};
  });
}

void require_same_connectivity(const TriMesh& mesh, const std::string& path, const TriMesh& first,
                               const std::string& first_path) {
  const auto refuse = [&](const std::string& difference) {
    throw InputError(path + ": its connectivity is not that of " + first_path + ": " + difference +
                     "; give meshes with the same vertices and facets in the same order");
  };
  if (mesh.vertex_count() != first.vertex_count()) {
    refuse("it has " + std::to_string(mesh.vertex_count()) + " vertices instead of " +
           std::to_string(first.vertex_count()));
  }
  if (mesh.facet_count() != first.facet_count()) {
    refuse("it has " + std::to_string(mesh.facet_count()) + " facets instead of " +
           std::to_string(first.facet_count()));
  }
  for (int f = 0; f < mesh.facet_count(); ++f) {
    if (mesh.facet(f) == first.facet(f)) continue;
    refuse("facet " + std::to_string(f) + " is " + shown(mesh.facet(f)) + " instead of " +
           shown(first.facet(f)));
  }
}

SeriesOutput::SeriesOutput(Command& command)
    : command_(command),
      output_(command.output_file(
          "Where to write: FOLDER/ (a .ply and .json for each shape), X.glb (an animation, binary glTF), "
          "or for one shape X.ply or - for standard output")) {
  command.options()
      .add_option("--seconds", seconds_, "Length of an animation in seconds")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.options()
      .add_option("--up", up_, "Upward axis of the models, for an animation: y or z")
      ->check(CLI::IsMember({"y", "z"}))
      ->capture_default_str();
}

bool SeriesOutput::is_animation() const {
  return std::filesystem::path(output_).extension() == ".glb";
}

bool SeriesOutput::is_folder() const {
  std::error_code ignored;
  return output_.ends_with('/') || std::filesystem::is_directory(output_, ignored);
}

std::string SeriesOutput::path_of(const std::string& name) const {
  return is_folder() ? (std::filesystem::path(output_) / (name + ".ply")).string() : output_;
}

void SeriesOutput::require_writable(const std::vector<std::string>& names) const {
  if (is_animation()) {
    std::error_code ignored;
    if (!command_.force() && !io::is_special_file(output_) && std::filesystem::exists(output_, ignored)) {
      throw IoError(output_ + ": exists already: give --force to replace it");
    }
    return;
  }
  if (!is_folder() && names.size() > 1) {
    throw UsageError("one file cannot hold " + std::to_string(names.size()) +
                     " shapes: give -o FOLDER/ (with the slash) or -o X.glb");
  }
  if (!is_folder()) {
    command_.require_document_output();
    return;
  }
  for (const std::string& name : names) io::require_writable(path_of(name), command_.force());
}

void SeriesOutput::write_animation(const Series& series) const {
  io::ShapeAnimation animation{series.name, series.mesh.facets(), series.shapes, series.names};
  animation.seconds = seconds_;
  animation.z_is_up = up_ == "z";
  if (series.looks) add_looks(animation, *series.looks);
  io::write_file(output_, command_.force(), [&](std::ostream& out) { io::write_glb(out, animation); });
}

void SeriesOutput::write(const Series& series, const std::vector<const io::Document*>& inputs) const {
  if (is_animation()) {
    write_animation(series);
    return;
  }
  if (is_folder()) {
    std::error_code failure;
    std::filesystem::create_directories(output_, failure);
    if (failure) throw IoError(output_ + ": cannot be made: " + failure.message());
  }
  for (std::size_t i = 0; i < series.shapes.size(); ++i) {
    io::Document document = io::to_document(series.mesh.with_points(series.shapes[i]));
    if (series.looks) {
      for (io::Element& element : document.tables.elements) {
        io::carry_columns(element, *series.looks->tables.find(element.name));
      }
      for (std::string& comment : io::texture_comments(series.looks->tables)) {
        document.tables.comments.push_back(std::move(comment));
      }
    }
    command_.write_to(path_of(series.names[i]), std::move(document), inputs, series.metrics[i]);
  }
}

}  // namespace partwise::cli
