#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "cli/command.h"
#include "io/pending_file.h"
#include "io/schema_validation.h"
#include "io/stage_documents.h"
#include "measure/certificate_document.h"
#include "measure/figures_table.h"
#include "measure/measure_document.h"
#include "measure/surface_field.h"
#include "remeshing/split_source.h"
#include "report/colored_mesh.h"

using namespace partwise;

namespace {

struct Options {
  std::vector<std::string> inputs{"-"};
  SurfaceDistanceOptions distance;
  std::string truth;
  std::string source;
  std::string distance_colors, distortion_colors, fold_colors;
  bool table = false;
  bool summary = false;
  bool certify = false;
  bool require_certificate = false;
};

void declare(cli::Command& command, Options& options) {
  CLI::App& app = command.options();
  app.add_option("compatible", options.inputs, "compatible meshes; - is standard input")->expected(-1);
  app.add_option("--samples", options.distance.samples, "points on each surface for the distances")
      ->check(CLI::Range(1, 100'000'000));
  app.add_option("--seed", options.distance.seed, "of the places of these points");
  app.add_option("--truth", options.truth,
                 "ground truth: \"identity\", or a file with a target vertex (0-based, -1 unknown) per line")
      ->type_name("identity|FILE");
  app.add_option("--source", options.source, "the source's mesh, to check that its facets are kept")
      ->check(CLI::ExistingFile);
  const auto declare_colors = [&](const std::string& name, std::string& file, const std::string& what) {
    app.add_option(name, file, "also write X.ply: " + what)->type_name("FILE");
  };
  declare_colors("--distance-colors", options.distance_colors,
                 "the target, coloured by its distance to the compatible mesh, 0 to 1 % of the diagonal");
  declare_colors("--distortion-colors", options.distortion_colors,
                 "the compatible mesh, coloured by the map's symmetric Dirichlet energy, 4 to 40");
  declare_colors("--fold-colors", options.fold_colors,
                 "the compatible mesh, coloured where facets intersect (1) or face against the target (2)");
  app.add_flag("--table", options.table, "print the figures as text; of several inputs a line for each")
      ->group("Common");
  app.add_flag("--certify", options.certify,
               "recompute from the files alone whether maps are one-to-one, and print the proof; inputs are "
               "compatible meshes, hull maps or cross maps")
      ->group("Common");
  app.add_flag("--summary", options.summary, "inputs are measure.json files: print a line for each")
      ->group("Common");
}

/// The name of a file's result in a table: the folder of X/measure.json, X of X.ply and the like.
std::string result_name(const std::string& path) {
  const std::filesystem::path absolute = std::filesystem::absolute(path);
  const std::string stem = absolute.stem().string();
  if (path == "-") return "standard input";
  const bool named_by_folder = stem == "measure" || stem == "compatible";
  return named_by_folder ? absolute.parent_path().filename().string() : stem;
}

void print(const std::string& text) {
  io::write_through("-", [&](std::ostream& out) { out << text; });
}

void write(const std::string& path, bool overwrite, const io::Json& document) {
  const std::string text = document.dump(1) + "\n";
  if (path == "-") return print(text);
  io::write_file(path, overwrite, [&](std::ostream& out) { out << text; });
}

std::optional<GroundTruth> ground_truth(cli::Command& command, const std::string& truth,
                                        const CompatibleMesh& mesh) {
  if (truth.empty()) return std::nullopt;
  // Vertices that relocate added have no truth.
  const TriMesh source = original_source(mesh);
  if (truth == "identity") return identity_truth(source, mesh.target);
  return command.about(truth, [&] {
    std::istringstream text(command.read_text(truth, "ground-truth"));
    return read_truth(text, source, mesh.target);
  });
}

io::Json history(const cli::Command& command, const io::Document& document, const Options& options) {
  io::HistoryEntry entry = command.history_entry();
  // Not a file, so it belongs to the arguments.
  if (options.truth == "identity") entry.arguments["truth"] = options.truth;
  return io::extend_history({&document}, entry);
}

void write_colors(const cli::Command& command, const std::string& file, const SurfaceField& field) {
  io::write_file(file, command.force(),
                 [&](std::ostream& out) { io::write_ply(out, report::colored_mesh(field)); });
}

void write_colors(const cli::Command& command, const Options& options, const CompatibleMesh& mesh) {
  if (!options.distance_colors.empty()) write_colors(command, options.distance_colors, distance_field(mesh));
  if (!options.distortion_colors.empty())
    write_colors(command, options.distortion_colors, distortion_field(mesh));
  if (!options.fold_colors.empty()) write_colors(command, options.fold_colors, fold_field(mesh));
}

io::Json measured(cli::Command& command, const std::string& path, const Options& options) {
  const io::Document document = command.read(path, {"compatible"});
  const CompatibleMesh mesh = command.about(path, [&] { return io::read_compatible_mesh(document); });
  const std::optional<GroundTruth> truth = ground_truth(command, options.truth, mesh);
  io::Json figures = command.about(path, [&] {
    return measure_document(measure(mesh, options.distance, truth),
                            stage_figures(document.metadata.value("metrics", io::Json())));
  });
  command.about(path, [&] { write_colors(command, options, mesh); });
  if (!options.source.empty()) {
    const io::Document source = command.read(options.source, {});
    figures["connectivity_kept"] = command.about(
        options.source, [&] { return io::read_mesh(source).facets() == original_source(mesh).facets(); });
  }
  if (const io::Json profile = command.profile(); !profile.empty()) figures["metrics"]["measure"] = profile;
  figures["history"] = history(command, document, options);
  return figures;
}

/// Writes the document of one input, prints the table of all.
void measure_all(cli::Command& command, const Options& options, const std::string& output) {
  const bool colors =
      !options.distance_colors.empty() || !options.distortion_colors.empty() || !options.fold_colors.empty();
  if (colors && options.inputs.size() > 1)
    throw UsageError("coloured meshes are written for one input: give one");
  const bool writes = !options.table || command.options().get_option("--output")->count() > 0;
  if (writes && options.inputs.size() > 1) {
    throw UsageError("one document is written for one input: give one, or --table without -o");
  }
  std::vector<NamedMeasure> measures;
  for (const std::string& path : options.inputs) {
    measures.push_back({result_name(path), measured(command, path, options)});
  }
  if (writes) {
    write(output, command.force(), measures.front().document);
  }
  if (options.table) {
    print(measures.size() == 1 ? figures_table(measures.front()) : summary_table(measures));
  }
  for (const NamedMeasure& measure : measures) {
    if (!options.require_certificate) break;  // the figures say it already
    const io::Json& certificate = measure.document.at("certificate");
    if (!certificate.at("one_to_one").get<bool>()) {
      command.check_certificate(certificate.at("reason").get<std::string>());
    }
  }
}

Certificate certified(cli::Command& command, const std::string& path) {
  const io::Document document = command.read(path, {"compatible", "hullmap", "crossmap"});
  return command.about(path, [&] {
    const std::string kind = document.metadata.at("schema").get<std::string>();
    if (kind == "partwise/hullmap-1") return certify(io::read_hull_map(document));
    if (kind == "partwise/crossmap-1") return certify(io::read_cross_map(document));
    return certify(io::read_compatible_mesh(document));
  });
}

/// Prints the certificates of all inputs.
void certify_all(cli::Command& command, const std::vector<std::string>& paths) {
  std::string text, missing;
  for (const std::string& path : paths) {
    const Certificate certificate = certified(command, path);
    text += certificate_text(path, certificate);
    if (certificate.one_to_one()) continue;
    missing += (missing.empty() ? "" : "; ") + path + ": " + certificate.first_reason();
  }
  print(text);
  command.check_certificate(missing);
}

io::Json read_measure(cli::Command& command, const std::string& path) {
  return command.about(path, [&] {
    const io::Json document = io::Json::parse(command.read_text(path, "partwise/measure-1"), nullptr, false);
    if (document.is_discarded()) throw InputError("is no JSON: make it anew with measure");
    io::validate(document, "measure-1");
    return document;
  });
}

/// The table of all documents that can be read; then fails for the others.
void summarize(cli::Command& command, const std::vector<std::string>& paths) {
  std::vector<NamedMeasure> measures;
  std::string problems;
  for (const std::string& path : paths) {
    try {
      measures.push_back({result_name(path), read_measure(command, path)});
    } catch (const IoError& error) {
      problems += (problems.empty() ? "" : "; ") + std::string(error.what());
    }
  }
  if (!measures.empty()) print(summary_table(measures));
  if (!problems.empty()) throw IoError(problems);
}

}  // namespace

int main(int argc, char** argv) {
  cli::Command command("measure", "Measure how good a compatible mesh is, as JSON and as a table.",
                       "measure compatible.ply --table -o measure.json");
  Options options;
  declare(command, options);
  const bool& require_certificate = command.certificate();
  const std::string& output =
      command.output_file("where to write the figures: X.json, or - for standard output");
  return command.run(argc, argv, [&] {
    options.require_certificate = require_certificate;
    if (options.certify) {
      certify_all(command, options.inputs);
    } else if (options.summary) {
      summarize(command, options.inputs);
    } else {
      measure_all(command, options, output);
    }
  });
}
