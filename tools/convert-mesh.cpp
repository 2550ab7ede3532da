#include <optional>
#include <utility>

#include "cli/command.h"
#include "error.h"
#include "io/mesh_files.h"
#include "io/sha256.h"
#include "io/stage_documents.h"
#include "io/texture_columns.h"
#include "mesh/repair.h"

using namespace partwise;

namespace {

struct Repairs {
  bool degenerate = false, duplicates = false, unused = false, orientation = false, largest = false;
  double tolerance = -1;  ///< over the diagonal; negative for no merging
};

void declare(CLI::App& options, Repairs& repairs) {
  options
      .add_option("--merge-vertices", repairs.tolerance, "Join vertices closer than this, over the diagonal")
      ->check(CLI::Range(0.0, 0.5))
      ->default_str("");
  options.add_flag("--drop-degenerate", repairs.degenerate, "Remove facets that name a vertex twice");
  options.add_flag("--drop-duplicates", repairs.duplicates, "Remove facets with the vertices of another");
  options.add_flag("--keep-largest-component", repairs.largest, "Keep the component with the most facets");
  options.add_flag("--orient", repairs.orientation, "Orient facets alike, outward where the mesh is closed");
  options.add_flag("--drop-unused", repairs.unused, "Remove vertices without facets");
}

/// Runs the repairs asked for, telling of each.
TriangleSoup repaired(TriangleSoup soup, const Repairs& repairs, const cli::Command& command,
                      io::Json& metrics) {
  const auto apply = [&](bool asked, const char* metric, const std::string& what, auto&& repair) {
    if (!asked) return;
    Repaired result = repair(std::move(soup));
    soup = std::move(result.soup);
    metrics[metric] = result.count;
    if (result.count > 0) command.warn(what + ": " + std::to_string(result.count));
  };
  require_indices(soup);
  apply(repairs.tolerance >= 0, "merged_vertices", "vertices joined to others",
        [&](TriangleSoup s) { return merge_vertices(std::move(s), repairs.tolerance); });
  apply(repairs.degenerate, "degenerate_facets_dropped", "degenerate facets removed", drop_degenerate);
  apply(repairs.duplicates, "duplicate_facets_dropped", "duplicate facets removed", drop_duplicates);
  apply(repairs.largest, "components_dropped", "smaller components removed", keep_largest_component);
  apply(repairs.orientation, "facets_turned", "facets turned over", orient);
  apply(repairs.unused, "unused_vertices_dropped", "vertices without facets removed", drop_unused);
  return soup;
}

void tell(const io::ImportedMesh& mesh, const cli::Command& command, io::Json& metrics) {
  metrics["polygons_triangulated"] = mesh.polygons;
  if (mesh.polygons > 0) {
    command.warn(std::to_string(mesh.polygons) +
                 " facets with more than three corners were cut into triangles");
  }
  if (mesh.merged_vertices > 0) {
    metrics["stl_corners_merged"] = mesh.merged_vertices;
    command.warn(std::to_string(mesh.merged_vertices) +
                 " corners equal to an earlier one were merged with it");
  }
  if (mesh.bare_facets > 0) {
    command.warn(std::to_string(mesh.bare_facets) +
                 " facets have no texture coordinates although others have: they get 0, 0");
  }
  for (const std::string& what : mesh.ignored) command.inform("ignored: " + what);
}

/// \param given the document that the mesh came with, if any
void add_texture(io::PlyTables& tables, const TextureCorners& texture,
                 const std::optional<io::Document>& given) {
  for (io::Property& column : io::texture_columns(texture)) {
    tables.elements[1].properties.push_back(std::move(column));
  }
  if (given) tables.comments = io::texture_comments(given->tables);
}

}  // namespace

int main(int argc, char** argv) {
  cli::Command command("convert-mesh",
                       "Bring a mesh in (OBJ, OFF, STL, PLY) or out (OBJ, OFF, STL, plain PLY).",
                       "convert-mesh cat.obj -o cat.ply\n  convert-mesh result.ply -o result.obj");
  const std::string& input = command.input("mesh", "A mesh (.obj .off .stl .ply) or any document", false);
  const std::string& output = command.output_file(
      "Where to write: X.ply (a document, with X.json), X.obj, X.off, X.stl, or - for standard output");
  bool plain = false;
  command.options().add_flag("--plain", plain, "Write a PLY without metadata");
  Repairs repairs;
  declare(command.options(), repairs);
  return command.run(argc, argv, [&] {
    const bool exported = plain || io::is_foreign_mesh_file(output);
    if (!exported) command.require_document_output();
    std::optional<io::Document> document;
    if (!io::is_foreign_mesh_file(input)) document = command.read(input, {});
    io::ImportedMesh imported = document ? io::import_ply(document->tables) : command.import_mesh(input);
    io::Json metrics = io::Json::object();
    tell(imported, command, metrics);
    TriangleSoup soup = command.about(input, [&] {
      return repaired({std::move(imported.points), std::move(imported.facets), std::move(imported.texture)},
                      repairs, command, metrics);
    });
    const TriMesh mesh =
        command.about(input, [&] { return TriMesh(std::move(soup.points), std::move(soup.facets)); });
    metrics["vertices"] = mesh.vertex_count();
    metrics["facets"] = mesh.facet_count();
    if (exported) {
      io::export_mesh(output, mesh.points(), mesh.facets(), command.force(), soup.texture);
      return;
    }
    std::vector<const io::Document*> inputs;
    if (document) inputs.push_back(&*document);
    io::Document written = io::to_document(mesh);
    if (soup.texture) add_texture(written.tables, *soup.texture, document);
    command.write(std::move(written), inputs, metrics);
  });
}
