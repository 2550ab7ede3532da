#include "report/run_documents.h"

#include <filesystem>
#include <fstream>
#include <functional>

#include "error.h"
#include "io/schema_validation.h"
#include "io/stage_documents.h"

namespace partwise::report {

namespace fs = std::filesystem;

namespace {

// The last part of a path that may end in a slash.
std::string folder_name(const std::string& folder) {
  return (fs::absolute(folder) / "").lexically_normal().parent_path().filename().string();
}

bool has_model(const std::string& prefix) {
  return fs::exists(prefix + ".segment.ply") || fs::exists(prefix + ".hull.ply") ||
         fs::exists(prefix + ".hullmap.ply");
}

using Use = std::function<void(const io::Document&)>;

StageState state_of(const std::string& title, const std::string& path) {
  StageState state{title, fs::path(path).filename().string(), "", false, io::Json::object(), ""};
  state.missing = !fs::exists(path);
  if (state.missing) state.trouble = "there is no such file";
  return state;
}

// Reads one stage's document and hands it to `use`; notes what goes wrong. Without `use` it only looks.
StageState read_stage(const std::string& title, const std::string& path, const std::string& kind,
                      const Use& use) {
  StageState state = state_of(title, path);
  if (state.missing || !use) return state;
  try {
    const io::Document document = io::read_document(path);
    if (document.kind() != kind) {
      throw InputError("is a document of kind " + document.kind() + " instead of " + kind);
    }
    use(document);
    state.metadata = document.metadata;
    state.digest = io::digest(document);
  } catch (const Error& error) {
    const std::string message = error.what();
    state.trouble = message.starts_with(path + ": ") ? message.substr(path.size() + 2) : message;
  }
  return state;
}

StageState read_measure(const std::string& path, io::Json& measure) {
  StageState state = state_of("measure", path);
  if (state.missing) return state;
  try {
    std::ifstream file(path, std::ios::binary);
    const io::Json document = io::Json::parse(file, nullptr, false);
    if (document.is_discarded()) throw InputError("is no JSON: make it anew with measure");
    io::validate(document, "measure-1");
    measure = document;
    state.metadata = document;
  } catch (const Error& error) {
    state.trouble = error.what();
  }
  return state;
}

// Reads the stages of one model, or only looks for them.
void read_model(const std::string& side, const std::string& prefix, bool look, RunDocuments& run,
                ModelStages& stages) {
  const auto read = [&](const std::string& tool, const std::string& kind, const Use& use) {
    run.stages.push_back(
        read_stage(tool + " (" + side + ")", prefix + "." + kind + ".ply", kind, look ? Use() : use));
  };
  read("segment", "segment", [&](const io::Document& d) { stages.model = io::read_segmented_model(d); });
  read("hull", "hull", [&](const io::Document& d) {
    const HulledModel hulled = io::read_hulled_model(d);
    stages = {hulled.model, hulled.parts, hulled.hulls, {}};
  });
  read("map-to-hull", "hullmap", [&](const io::Document& d) {
    const HullMap map = io::read_hull_map(d);
    stages = {map.hulled.model, map.hulled.parts, map.hulled.hulls, map.images};
  });
}

// What the model's own documents do not say, a later one may.
void complete(ModelStages& stages, const SegmentedModel& model) {
  if (!stages.model) stages.model = model;
}

void complete(ModelStages& stages, const TriMesh& mesh, const std::vector<std::string>& names,
              const std::vector<int>& labels) {
  if (!stages.model) stages.model = SegmentedModel{mesh, trace_boundaries(mesh, names, labels), {}, {}, {}};
}

bool same_mesh(const ModelStages& stages, const TriMesh& mesh) {
  return !stages.model || stages.model->mesh.key() == mesh.key();
}

bool same_parts(const ModelStages& stages, const SegmentedModel& model) {
  return same_mesh(stages, model.mesh) && stages.model->segmentation.names == model.segmentation.names &&
         stages.model->segmentation.labels == model.segmentation.labels;
}

void complete_models(RunDocuments& run) {
  if (run.cross_map) {
    complete(run.source, run.cross_map->source);
    complete(run.target, run.cross_map->target.hulled.model);
  }
  for (const auto* mesh : {&run.compatible, &run.critical, &run.reconstructed}) {
    if (!*mesh) continue;
    const CompatibleMesh& m = **mesh;
    complete(run.source, m.source, m.part_names, m.source_labels);
    complete(run.target, m.target, m.part_names, m.target_labels);
  }
}

template <class Stage>
void drop_if_foreign(StageState& state, std::optional<Stage>& stage, bool fits) {
  if (!stage || fits) return;
  stage.reset();
  state.trouble = "was made from other meshes than the documents of the models; make it anew";
}

void drop_foreign(RunDocuments& run) {
  StageState* states = &run.stages[6];
  if (run.cross_map) {
    drop_if_foreign(states[0], run.cross_map,
                    same_parts(run.source, run.cross_map->source) &&
                        same_parts(run.target, run.cross_map->target.hulled.model));
  }
  int i = 1;
  for (auto* mesh : {&run.reconstructed, &run.critical, &run.compatible}) {
    const bool fits =
        !*mesh || (same_mesh(run.source, (*mesh)->source) && same_mesh(run.target, (*mesh)->target));
    drop_if_foreign(states[i++], *mesh, fits);
  }
}

}  // namespace

RunPlaces run_places(const std::string& folder) {
  RunPlaces places{folder, folder + "/source", folder + "/target"};
  if (has_model(places.source) || has_model(places.target)) return places;
  const std::string name = folder_name(folder);
  const std::string models = (fs::path(folder) / ".." / "models").string();
  for (std::size_t dash = name.find('-'); dash != std::string::npos; dash = name.find('-', dash + 1)) {
    const std::string source = models + "/" + name.substr(0, dash);
    const std::string target = models + "/" + name.substr(dash + 1);
    if (!has_model(source) && !has_model(target)) continue;
    places.source = source;
    places.target = target;
    if (has_model(source) && has_model(target)) break;
  }
  return places;
}

bool is_run_folder(const std::string& folder) {
  if (!fs::is_directory(folder)) return false;
  // A pair whose models could not be made has settings of its stages, and nothing else.
  for (const char* file : {"measure.json", "compatible.ply", "critical.ply", "reconstructed.ply",
                           "crossmap.ply", ".settings/crossmap"}) {
    if (fs::exists(fs::path(folder) / file)) return true;
  }
  return false;
}

const io::Json& RunDocuments::last_metadata() const {
  static const io::Json none = io::Json::object();
  for (auto stage = stages.rbegin(); stage != stages.rend(); ++stage) {
    if (stage->title != "measure" && stage->trouble.empty()) return stage->metadata;
  }
  return none;
}

RunDocuments read_run(const RunPlaces& places, RunDepth depth) {
  if (!fs::is_directory(places.folder)) {
    throw IoError(places.folder + ": is no folder; name the one that holds a pair");
  }
  RunDocuments run;
  run.name = folder_name(places.folder);
  const auto into = [](std::optional<CompatibleMesh>& mesh) {
    return [&mesh](const io::Document& d) { mesh.emplace(io::read_compatible_mesh(d)); };
  };
  const auto in_folder = [&](const std::string& name) { return places.folder + "/" + name; };
  const StageState compatible =
      read_stage("relocate", in_folder("compatible.ply"), "compatible", into(run.compatible));
  const StageState measure = read_measure(in_folder("measure.json"), run.measure);
  const bool look = depth == RunDepth::result && compatible.trouble.empty() && measure.trouble.empty();
  read_model("source", places.source, look, run, run.source);
  read_model("target", places.target, look, run, run.target);
  const auto read = [&](const std::string& tool, const std::string& name, const std::string& kind,
                        const Use& use) {
    run.stages.push_back(read_stage(tool, in_folder(name), kind, look ? Use() : use));
  };
  read("hull-to-hull", "crossmap.ply", "crossmap",
       [&](const io::Document& d) { run.cross_map = io::read_cross_map(d); });
  read("reconstruct", "reconstructed.ply", "compatible", into(run.reconstructed));
  read("critical-points", "critical.ply", "compatible", into(run.critical));
  run.stages.push_back(compatible);
  run.stages.push_back(measure);
  bool any = false;
  for (const StageState& stage : run.stages) any = any || stage.trouble.empty();
  if (!any) {
    throw InputError("there is no document of a pair in it that can be read (" + run.stages.front().file +
                     ": " + run.stages.front().trouble +
                     "); name a folder that cross-parameterize.mk filled");
  }
  complete_models(run);
  drop_foreign(run);
  return run;
}

}  // namespace partwise::report
