#include "remeshing/relocate.h"

#include <map>
#include <sstream>

#include "cli/command.h"
#include "io/chart_tables.h"
#include "io/stage_documents.h"

namespace {

using namespace partwise;

const std::map<std::string, RelocateMethod> kMethods{{"relax", RelocateMethod::relax},
                                                     {"umbrella", RelocateMethod::umbrella}};
const std::map<std::string, LaplacianKind> kWeights{{"mean-value", LaplacianKind::mean_value},
                                                    {"uniform", LaplacianKind::uniform}};

/// The options as the user writes them.
struct Choice {
  std::string method = "relax";
  std::string umbrella_weights = "mean-value";
};

void declare_choice(CLI::App& app, Choice& choice) {
  app.add_option("--method", choice.method,
                 "relax: move vertices within the one-to-one map; umbrella: the paper's own scheme, for "
                 "comparison, which may fold (options --rounds, --lambda, --critical-...)")
      ->check(CLI::IsMember(kMethods))
      ->capture_default_str();
  app.add_option("--umbrella-weights", choice.umbrella_weights,
                 "umbrella: how much each neighbour of a vertex counts; uniform loses the source's features")
      ->check(CLI::IsMember(kWeights))
      ->capture_default_str();
}

void declare_options(CLI::App& app, RelocateOptions& options) {
  app.add_option("--rounds", options.rounds, "Rounds of vertex relocation, Eq. (18)")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  app.add_option(
         "--lambda", options.lambda,
         "Share of the way to the weighted mean of the neighbours in each round, above 0 and at most 1")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  app.add_option("--relax-iterations", options.relaxation.iterations,
                 "Newton iterations that even out the whole map's distortion")
      ->check(CLI::Range(0, 10000))
      ->capture_default_str();
  app.add_option(
         "--registration-steps", options.registration.steps,
         "Steps of a registration of the source to the target, by place, normal and relief, that draws the "
         "map; 0: none")
      ->check(CLI::Range(0, 100))
      ->capture_default_str();
  app.add_option(
         "--registration-reach", options.registration.reach,
         "How far from a vertex's image the registration looks for its match, over the target's diagonal")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--relax-sweeps", options.relax_sweeps, "Sweeps that even out the map's distortion")
      ->check(CLI::Range(0, 10000))
      ->capture_default_str();
  app.add_option(
         "--critical-iterations", options.critical.iterations,
         "Rounds of pulling vertices to critical points, Eq. (17); 0: ignore critical points, as in the "
         "paper's Fig. 11c")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  app.add_option("--critical-weight", options.critical.weight,
                 "Weight of the critical points against the Laplacian energy")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--unfold-sweeps", options.unfold.sweeps, "Sweeps over the surroundings of flipped facets")
      ->check(CLI::Range(0, 10000))
      ->capture_default_str();
  app.add_option("--gap-rounds", options.gaps.rounds,
                 "Rounds of sliding the whole map to where it and the target are apart")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  app.add_option(
         "--gap-threshold", options.gaps.threshold,
         "Gaps between the surfaces that are wider than this are closed so, over the target's diagonal")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--fit-rounds", options.fit.rounds,
                 "Rounds of pulling vertices to details of the target that the mesh misses")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  app.add_option("--fit-far-rounds", options.fit.far_rounds,
                 "Further rounds for what is missed by 0.2 % of the diagonal, which may flatten facets")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  app.add_option("--fit-threshold", options.fit.threshold,
                 "Distance from which a target vertex counts as missed, over the target's diagonal")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--refine", options.refine.error,
                 "Add vertices to the source until the two-sided distance is below this, over the target's "
                 "diagonal; 0: add none")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--refine-limit", options.refine.limit,
                 "Vertices that --refine may add, as a share of the source's own")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
}

void warn_of_gaps(cli::Command& command, const RefineFigures& figures, const RefineOptions& options) {
  if (figures.gaps_after == 0) return;
  std::ostringstream text;
  text << figures.gaps_after << " of the places looked at are still more than " << options.error
       << " of the diagonal apart after adding " << figures.added_vertices
       << " vertices; give a larger --refine, or a larger --refine-limit if that was reached";
  command.warn(text.str());
}

io::Json metrics_of(const RelocateMetrics& m, const std::vector<std::string>& part_names) {
  io::Json metrics{
      {"critical_points", m.critical_points},
      {"critical_points_reached", m.critical_reached},
      {"rounds", m.rounds},
      {"fit_moves", m.fit_moves},
      {"refined_vertices", m.refine.added_vertices},
      {"flipped_faces", {{"before", m.flipped_before}, {"after", m.flipped_after}}},
      {"target_vertices_rms_distance", {{"before", m.rms_distance_before}, {"after", m.rms_distance_after}}},
      {"target_vertices_max_distance", {{"before", m.max_distance_before}, {"after", m.max_distance_after}}}};
  if (m.refine.gaps_before > 0) {
    metrics["refinement"] = {{"rounds", m.refine.rounds},
                             {"gaps", {{"before", m.refine.gaps_before}, {"after", m.refine.gaps_after}}}};
  }
  if (!m.charts.empty()) metrics.update(io::chart_metrics(m.charts, part_names));
  return metrics;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Command command("relocate",
                       "Move a compatible mesh over its target: onto its features, into the source's shape.",
                       "relocate cat-lion.critical.ply -o cat-lion.relocated.ply");
  const std::string& input =
      command.input("mesh", "Compatible mesh, as critical-points or reconstruct writes it");
  command.output();
  RelocateOptions options;
  Choice choice;
  declare_choice(command.options(), choice);
  declare_options(command.options(), options);
  command.certificate();
  return command.run(argc, argv, [&] {
    options.method = kMethods.at(choice.method);
    options.umbrella_weights = kWeights.at(choice.umbrella_weights);
    const io::Document document = command.read(input, {"compatible"});
    const Relocation result =
        command.about(input, [&] { return relocate(io::read_compatible_mesh(document), options); });
    if (result.metrics.flipped_after > 0) {
      command.warn(std::to_string(result.metrics.flipped_after) +
                   " facets face the target's inside; try more "
                   "--unfold-sweeps, or look at the folds that hull-to-hull reports");
    }
    warn_of_gaps(command, result.metrics.refine, options.refine);
    command.check_certificate(result.metrics.charts.empty()
                                  ? "the mesh came without charts; see the warnings of reconstruct"
                                  : io::uncertified(result.metrics.charts, result.mesh.part_names));
    command.write(io::to_document(result.mesh), {&document},
                  metrics_of(result.metrics, result.mesh.part_names));
  });
}
