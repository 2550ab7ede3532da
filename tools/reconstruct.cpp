#include "remeshing/reconstruct.h"

#include <map>

#include "cli/command.h"
#include "io/chart_tables.h"
#include "io/stage_documents.h"

namespace {

using namespace partwise;

const std::map<std::string, Coordinates> kCoordinates{{"facet", Coordinates::facet},
                                                      {"convex-hull", Coordinates::convex_hull},
                                                      {"mean-value", Coordinates::mean_value}};

void declare_options(CLI::App& app, std::string& coordinates, ReconstructOptions& options) {
  app.add_option("--coordinates", coordinates,
                 "facet: by the target's facet that contains the vertex; convex-hull, mean-value: as in the "
                 "paper, averaged over the target's vertices near it, then projected to the target")
      ->check(CLI::IsMember(kCoordinates))
      ->capture_default_str();
  app.add_option(
         "--radius", options.radius,
         "convex-hull, mean-value: reach of the averaging, in mean edge lengths of the target's part on "
         "its hull")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_flag("!--leave-folds", options.one_to_one,
               "leave the map as the parts' maps make it, folds at their seams included");
}

io::Json metrics_of(const Reconstruction& result, Coordinates coordinates) {
  io::Json metrics{{"vertices", result.mesh.points.size()},
                   {"ambiguous", result.metrics.ambiguous},
                   {"on_caps", result.metrics.on_caps},
                   {"boundary_gap_max", result.metrics.boundary_gap_max}};
  if (!result.metrics.charts.empty()) {
    metrics.update(io::chart_metrics(result.metrics.charts, result.mesh.part_names));
    metrics["moved_vertices"] = result.metrics.moved_vertices;
    metrics["curves_held"] = result.metrics.curves_held;
    metrics["placed_markers"] = result.metrics.placed_markers;
  }
  if (coordinates != Coordinates::facet) metrics["largest_projection"] = result.metrics.largest_projection;
  return metrics;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Command command("reconstruct",
                       "Give every source vertex its place on the target: the compatible mesh.",
                       "reconstruct cat-lion.crossmap.ply -o cat-lion.compatible.ply");
  const std::string& input =
      command.input("crossmap", "Source mapped onto the target's hulls, as hull-to-hull writes it");
  command.output();
  ReconstructOptions options;
  std::string coordinates = "facet";
  declare_options(command.options(), coordinates, options);
  command.certificate();
  return command.run(argc, argv, [&] {
    options.coordinates = kCoordinates.at(coordinates);
    const io::Document document = command.read(input, {"crossmap"});
    const Reconstruction result =
        command.about(input, [&] { return reconstruct(io::read_cross_map(document), options); });
    if (result.metrics.ambiguous > 0) {
      command.warn(std::to_string(result.metrics.ambiguous) +
                   " vertices lie behind several facets of a folded hull map; took those nearest to their "
                   "neighbours, relocate may unfold them");
    }
    if (options.one_to_one) {
      command.check_certificate(io::uncertified(result.metrics.charts, result.mesh.part_names));
    }
    command.write(io::to_document(result.mesh), {&document}, metrics_of(result, options.coordinates));
  });
}
