#include <charconv>
#include <cmath>
#include <map>
#include <optional>

#include "cli/series.h"
#include "deform/aligned_model.h"
#include "deform/shape_blend.h"
#include "io/model_tables.h"
#include "measure/inverted_facets.h"

using namespace partwise;

namespace {

const std::string kSourcePrefix = "source=";
constexpr int kFrames = 25;
constexpr double kSizesApart = 3;  ///< a ratio that people are told of

struct Request {
  std::vector<std::string> models;
  int frames = 0;
  std::vector<double> places;
  std::vector<std::string> weights;
  std::string method = "rotations";
  bool align = false;
};

void declare(CLI::App& app, Request& request) {
  app.add_option("model", request.models,
                 "Meshes of one connectivity, such as compatible meshes with one source; source=FILE is the "
                 "source of a compatible mesh. One compatible mesh alone stands for its source and itself")
      ->required();
  CLI::Option* frames =
      app.add_option("--frames", request.frames,
                     "Frames from the first model to the last, through all of them; 25 if nothing is said")
          ->check(CLI::Range(1, 100000))
          ->default_str("");
  CLI::Option* places = app.add_option("--at", request.places,
                                       "Places on that way, 0 for the first model, 1 for the second and so "
                                       "on; 0.5 is half-way, -0.2 or 1.3 beyond the ends")
                            ->delimiter(',')
                            ->excludes(frames);
  app.add_option("--weights", request.weights,
                 "Weights of the models, such as 0.5,0.3,0.2; again for another frame; any number, negative "
                 "ones too")
      ->allow_extra_args(false)
      ->excludes(frames)
      ->excludes(places);
  app.add_option("--method", request.method,
                 "rotations: facets turn and stretch, so that a swung leg keeps its length; linear: vertices "
                 "move straight")
      ->check(CLI::IsMember({"rotations", "linear"}))
      ->capture_default_str();
  app.add_flag("--align", request.align,
               "Scale, turn and move the models onto the first, so that only their shapes are blended");
}

std::vector<double> numbers_of(const std::string& text) {
  std::vector<double> numbers;
  for (const char *at = text.data(), *end = at + text.size(); at <= end; ++at) {
    double number = 0;
    const auto [after, error] = std::from_chars(at, end, number);
    if (error != std::errc() || !std::isfinite(number) || (after != end && *after != ',')) {
      throw UsageError("--weights \"" + text + "\" is no list of numbers such as 0.5,0.3,0.2");
    }
    numbers.push_back(number);
    at = after;
  }
  return numbers;
}

std::string number_text(double number) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, number).ptr};
}

/// The rows of weights asked for; where a single document is written and nothing is said, the mean.
std::vector<std::vector<double>> weights_of(const Request& request, int models, bool many) {
  std::vector<std::vector<double>> rows;
  for (const std::string& text : request.weights) {
    rows.push_back(numbers_of(text));
    if (static_cast<int>(rows.back().size()) != models) {
      throw UsageError("--weights " + text + ": there are " + std::to_string(models) +
                       " models; give one weight for each");
    }
  }
  for (const double place : request.places) rows.push_back(weights_at(models, place));
  if (!rows.empty()) return rows;
  if (request.frames > 0 || many) return weights_along(models, request.frames > 0 ? request.frames : kFrames);
  return {std::vector<double>(models, 1.0 / models)};
}

void warn_of_sums(const cli::Command& command, const std::vector<std::vector<double>>& rows) {
  for (const std::vector<double>& row : rows) {
    double sum = 0;
    for (const double weight : row) sum += weight;
    if (std::abs(sum - 1) < 1e-9) continue;
    command.warn("the weights add up to " + number_text(sum) +
                 ", not to 1: the blend is scaled about the origin by that");
    return;
  }
}

struct Models {
  std::vector<TriMesh> meshes;
  std::vector<std::string> names;
  std::map<std::string, cli::ModelInput> files;  // each once
  std::vector<std::string> order;                // of the files, as on the command line

  const cli::ModelInput& file(cli::Command& command, const std::string& path) {
    const auto found = files.find(path);
    if (found != files.end()) return found->second;
    order.push_back(path);
    return files.emplace(path, cli::read_model(command, path)).first->second;
  }
};

Models read_models(cli::Command& command, const std::vector<std::string>& arguments) {
  Models models;
  for (const std::string& argument : arguments) {
    const bool of_source = argument.starts_with(kSourcePrefix);
    const std::string file = of_source ? argument.substr(kSourcePrefix.size()) : argument;
    const cli::ModelInput& input = models.file(command, file);
    const bool compatible = input.document && input.document->kind() == "compatible";
    if (of_source && !compatible) {
      throw UsageError(argument + ": has no source, for it is no compatible mesh");
    }
    if (of_source || (compatible && arguments.size() == 1)) {
      models.meshes.push_back(command.about(
          file, [&] { return io::read_mesh(input.document->tables, "source_vertex", "face"); }));
      models.names.push_back(kSourcePrefix + file);
    }
    if (!of_source) {
      models.meshes.push_back(input.mesh);
      models.names.push_back(file);
    }
  }
  if (models.meshes.size() < 2) throw UsageError("one model is nothing to morph: give two or more");
  for (std::size_t i = 1; i < models.meshes.size(); ++i) {
    cli::require_same_connectivity(models.meshes[i], models.names[i], models.meshes[0], models.names[0]);
  }
  return models;
}

/// The models but the first, aligned if that is wanted; else a warning where sizes are far apart.
std::vector<Points> other_shapes(const cli::Command& command, const Models& models, bool align) {
  const TriMesh& first = models.meshes[0];
  const double area = surface_area(first.points(), first.facets());
  std::vector<Points> shapes;
  for (std::size_t i = 1; i < models.meshes.size(); ++i) {
    const Points& points = models.meshes[i].points();
    shapes.push_back(align ? aligned_model(points, first.points(), first.facets()) : points);
    const double ratio = std::sqrt(surface_area(points, first.facets()) / area);
    if (align || (ratio < kSizesApart && ratio > 1 / kSizesApart)) continue;
    command.warn(models.names[i] + " is " + number_text(std::round(100 * ratio) / 100) +
                 " times as large as " + models.names[0] +
                 ", so weights count accordingly; --align brings them to one size");
  }
  return shapes;
}

std::vector<std::string> frame_names(std::size_t count) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string digits = std::to_string(i);
    names.push_back(std::string(digits.size() < 4 ? 4 - digits.size() : 0, '0') + digits);
  }
  return names;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Command command("morph", "Blend the shapes of meshes that share one connectivity.",
                       "morph cat-lion/compatible.ply -o cat-lion.glb\n"
                       "  morph source=a.ply a.ply b.ply --weights 0.5,0.3,0.2 -o blend.ply");
  Request request;
  declare(command.options(), request);
  const cli::SeriesOutput output(command);
  return command.run(argc, argv, [&] {
    const Models models = read_models(command, request.models);
    const auto weights = weights_of(request, static_cast<int>(models.meshes.size()),
                                    output.is_folder() || output.is_animation());
    warn_of_sums(command, weights);
    const std::vector<std::string> names = frame_names(weights.size());
    output.require_writable(names);
    const std::vector<Points> others = other_shapes(command, models, request.align);
    const ShapeBlend blend(models.meshes[0], others,
                           request.method == "linear" ? BlendMethod::linear : BlendMethod::rotations);
    cli::Series series{"morph", models.meshes[0], blend.frames(weights), names, {}};
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const auto inverted = inverted_facets(series.shapes[i], series.mesh.facets());
      series.metrics.push_back({{"weights", weights[i]}, {"inverted_faces", inverted.size()}});
    }
    std::vector<const io::Document*> inputs;
    for (const std::string& path : models.order) {
      const auto& document = models.files.at(path).document;
      if (document) inputs.push_back(&*document);
      if (path == models.order.front() && document) series.looks = &*document;
    }
    output.write(series, inputs);
  });
}
