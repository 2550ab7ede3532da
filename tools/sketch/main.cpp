#include <spawn.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "cli/command.h"
#include "error.h"
#include "io/mesh_files.h"
#include "io/stage_documents.h"
#include "report/page.h"
#include "report/palette.h"
#include "sketch/server.h"
#include "sketching/requests.h"

using namespace partwise;
namespace fs = std::filesystem;

namespace {

constexpr int kTokenOctets = 16;

struct Options {
  std::vector<std::string> meshes, sketches{"", ""};
  std::string folder;
  int port = 0;
  bool open = false;
};

void declare(CLI::App& app, Options& options) {
  app.add_option("meshes", options.meshes, "One or two meshes: PLY, OBJ, OFF or STL")
      ->type_name("FILE")
      ->required()
      ->expected(1, 2);
  app.add_option("--sketch-a", options.sketches[0],
                 "Sketch of the first mesh, loaded and saved; by default beside it, MESH.sketch.json")
      ->type_name("FILE")
      ->default_str("");
  app.add_option("--sketch-b", options.sketches[1], "The same for the second mesh")
      ->type_name("FILE")
      ->default_str("");
  app.add_option("--out", options.folder,
                 "Folder for the results of runs started from the page; by default A-B in the current folder")
      ->type_name("FOLDER")
      ->default_str("");
  app.add_option("--port", options.port, "Port of 127.0.0.1; 0 is any that is free")
      ->check(CLI::Range(0, 65535));
  app.add_flag("--open", options.open, "Also open the page in the browser");
}

TriMesh read_any_mesh(cli::Command& command, const std::string& path) {
  return command.about(path, [&] {
    if (!io::is_foreign_mesh_file(path)) return io::read_mesh(command.read(path, {"mesh"}));
    io::ImportedMesh mesh = command.import_mesh(path);
    return TriMesh(std::move(mesh.points), std::move(mesh.facets));
  });
}

std::string sketch_beside(const std::string& mesh) {
  return fs::path(mesh).replace_extension(".sketch.json").string();
}

/// Of an installation or of a build: relative to where the executables lie.
sketching::PipelinePlaces places(const std::vector<std::unique_ptr<sketching::SketchedModel>>& models,
                                 const std::string& folder) {
  const fs::path tools = fs::read_symlink("/proc/self/exe").parent_path();
  fs::path makefile = tools / "../../share/partwise/pipelines/cross-parameterize.mk";
  if (!fs::exists(makefile)) makefile = tools / "../../../pipelines/cross-parameterize.mk";
  const auto absolute = [](const std::string& path) {
    return fs::absolute(path).lexically_normal().string();
  };
  return {makefile.lexically_normal().string(),
          tools.string(),
          absolute(models[0]->mesh_path()),
          absolute(models[0]->sketch_path()),
          absolute(models[1]->mesh_path()),
          absolute(models[1]->sketch_path()),
          absolute(folder.empty() ? models[0]->name() + "-" + models[1]->name() : folder)};
}

void open_in_browser(const cli::Command& command, std::string address) {
  std::string program = "xdg-open";
  char* arguments[] = {program.data(), address.data(), nullptr};
  pid_t process = 0;
  if (posix_spawnp(&process, "xdg-open", nullptr, nullptr, arguments, environ) != 0) {
    command.warn("there is no xdg-open here: open the address yourself");
  }
}

void sketch(cli::Command& command, const Options& options) {
  std::vector<std::unique_ptr<sketching::SketchedModel>> models;
  for (std::size_t i = 0; i < options.meshes.size(); ++i) {
    const std::string& mesh = options.meshes[i];
    const std::string& path = options.sketches[i];
    models.push_back(std::make_unique<sketching::SketchedModel>(mesh, read_any_mesh(command, mesh),
                                                                path.empty() ? sketch_beside(mesh) : path));
  }
  const auto same_file = [](const std::string& a, const std::string& b) {
    return fs::weakly_canonical(fs::absolute(a)) == fs::weakly_canonical(fs::absolute(b));
  };
  if (models.size() == 2 && same_file(models[0]->sketch_path(), models[1]->sketch_path())) {
    throw UsageError("both meshes would share the sketch " + models[0]->sketch_path() +
                     "; say --sketch-a and --sketch-b");
  }
  std::string title = models[0]->name();
  for (std::size_t i = 1; i < models.size(); ++i) title += " - " + models[i]->name();
  std::unique_ptr<sketching::PipelineRun> run;
  if (models.size() == 2) run = std::make_unique<sketching::PipelineRun>(places(models, options.folder));
  const std::string token = sketching::random_token(kTokenOctets);
  sketching::Requests requests(
      token,
      report::html_page(report::Page::sketch, title, io::Json::object({{"part_colors", report::kPartColors}}),
                        {}),
      std::move(models), std::move(run));
  sketching::serve(requests, options.port, [&](int port) {
    const std::string address = "http://127.0.0.1:" + std::to_string(port) + "/" + token + "/";
    std::cout << address << std::endl;
    if (options.open) open_in_browser(command, address);
  });
}

}  // namespace

int main(int argc, char** argv) {
  cli::Command command("sketch", "Draw strokes and pick markers on one or two models in a browser.",
                       "sketch cat.ply lion.ply --open");
  Options options;
  declare(command.options(), options);
  return command.run(argc, argv, [&] { sketch(command, options); });
}
