#include "cli/command.h"
#include "error.h"
#include "io/stage_documents.h"
#include "report/colored_mesh.h"
#include "report/pov_scene.h"

using namespace partwise;

namespace {

constexpr const char* kAspects[] = {"mesh", "source", "target"};

/// A file on the command line: all of it, or one aspect as in mesh=FILE.
struct Shown {
  std::string aspect;
  std::string file;
};

Shown parse_shown(const std::string& word) {
  for (const std::string aspect : kAspects) {
    if (word.starts_with(aspect + "=")) return {aspect, word.substr(aspect.size() + 1)};
  }
  return {"", word};
}

report::Panel panel_of(const io::Document& document, const std::string& aspect) {
  const std::string kind = document.kind();
  if (aspect.empty() && kind == "mesh" && report::has_vertex_colors(document.tables)) {
    return report::colored_panel(document.tables);
  }
  if (aspect == "source") return report::source_panel(io::read_compatible_mesh(document));
  if (aspect == "target") return report::target_panel(io::read_compatible_mesh(document));
  if (aspect == "mesh" || kind == "mesh") return report::mesh_panel(io::read_mesh(document));
  if (kind == "segment") return report::parts_panel(io::read_segmented_model(document));
  if (kind == "hull") return report::hulls_panel(io::read_hulled_model(document));
  if (kind == "hullmap") return report::hull_map_panel(io::read_hull_map(document));
  if (kind == "crossmap") return report::cross_map_panel(io::read_cross_map(document));
  return report::compatible_panel(io::read_compatible_mesh(document));
}

// Of `values`, the one for panel `i`: one for each panel, one for all, or none.
std::string for_panel(const std::vector<std::string>& values, std::size_t i, std::size_t panels,
                      const std::string& option) {
  if (values.empty()) return "auto";
  if (values.size() != 1 && values.size() != panels) {
    throw UsageError(option + ": give it once, or once for each of the " + std::to_string(panels) +
                     " panels");
  }
  return values.size() == 1 ? values[0] : values[i];
}

}  // namespace

int main(int argc, char** argv) {
  cli::Command command("picture", "Draw documents side by side, as a scene for POV-Ray.",
                       "picture cat.segment.ply cat.hullmap.ply -o cat.pov");
  std::vector<std::string> files;
  std::vector<std::string> views;
  std::vector<std::string> captions;
  report::SceneOptions options;
  CLI::App& app = command.options();
  app.add_option(
         "document", files,
         "Documents of any kind; meshes with coloured vertices are shown with their colours; mesh=FILE shows "
         "the bare mesh of FILE, source=FILE and target=FILE the models of a compatible mesh")
      ->required();
  app.add_option(
         "--view", views,
         "Where to look from, for all panels or once for each: auto, or x,y,z,x,y,z, the direction to the "
         "eye and the upward direction")
      ->allow_extra_args(false);
  app.add_option("--caption", captions, "Caption, for all panels or once for each; auto says what is shown")
      ->allow_extra_args(false);
  app.add_option("--columns", options.columns, "Panels side by side")->check(CLI::PositiveNumber);
  app.add_option("--width", options.width, "Width of the picture in pixels")->check(CLI::PositiveNumber);
  const std::string& output = command.output_file("Where to write the scene, X.pov; - is standard output");
  return command.run(argc, argv, [&] {
    std::vector<report::Panel> panels;
    for (std::size_t i = 0; i < files.size(); ++i) {
      const Shown shown = parse_shown(files[i]);
      const bool of_pair = shown.aspect == "source" || shown.aspect == "target";
      const io::Document document = command.read(
          shown.file, of_pair ? std::vector<std::string>{"compatible"} : std::vector<std::string>{});
      report::Panel panel = command.about(shown.file, [&] { return panel_of(document, shown.aspect); });
      const std::string view = for_panel(views, i, files.size(), "--view");
      if (view != "auto") panel.view = report::parse_view(view);
      const std::string caption = for_panel(captions, i, files.size(), "--caption");
      if (caption != "auto") panel.caption = caption;
      panels.push_back(std::move(panel));
    }
    command.write_text(output, report::pov_scene(panels, options));
  });
}
