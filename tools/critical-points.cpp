#include "cli/command.h"
#include "io/stage_documents.h"
#include "remeshing/critical_points.h"

namespace {

using namespace partwise;

void declare_options(CLI::App& app, CriticalPointOptions& options) {
  app.add_option(
         "--fraction", options.fraction,
         "Largest number of critical points, as a share of the vertices (of the coarser mesh of a pair)")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  app.add_option("--count", options.count,
                 "Largest number of critical points; 0: only --fraction bounds them")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
}

io::Json metrics_of(const CriticalPoints& critical, int vertices) {
  return {{"critical_points", critical.points.size()},
          {"share_of_vertices", static_cast<double>(critical.points.size()) / vertices},
          {"radius_scale", critical.radius_scale}};
}

/// The mesh alone, with its own critical points in a table.
io::Document mesh_document(const TriMesh& mesh, const CriticalPoints& critical) {
  io::Document document = io::to_document(mesh);
  document.tables.elements.push_back(io::critical_point_element("vertex", critical.points));
  return document;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Command command(
      "critical-points",
      "Find the vertices that carry the features of a compatible mesh's target, or of a mesh.",
      "critical-points cat-lion.compatible.ply -o cat-lion.critical.ply");
  const std::string& input = command.input("mesh", "Compatible mesh, as reconstruct writes it, or a mesh");
  command.output();
  CriticalPointOptions options;
  declare_options(command.options(), options);
  return command.run(argc, argv, [&] {
    const io::Document document = command.read(input, {"compatible", "mesh"});
    if (document.kind() == "mesh") {
      const TriMesh mesh = command.about(input, [&] { return io::read_mesh(document); });
      const CriticalPoints critical = find_critical_points(mesh, options);
      command.write(mesh_document(mesh, critical), {&document}, metrics_of(critical, mesh.vertex_count()));
      return;
    }
    CompatibleMesh mesh = command.about(input, [&] { return io::read_compatible_mesh(document); });
    const CriticalPoints critical = find_critical_points(mesh, options);
    mesh.critical_points = critical.points;
    command.write(io::to_document(mesh), {&document}, metrics_of(critical, mesh.target.vertex_count()));
  });
}
