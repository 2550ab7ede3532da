#include <algorithm>
#include <cmath>
#include <map>

#include "cli/command.h"
#include "io/stage_documents.h"
#include "mapping/map_to_hull.h"

namespace {

using namespace partwise;

const std::map<std::string, HullMapMethod> kMethods{{"progressive", HullMapMethod::progressive},
                                                    {"lifted", HullMapMethod::lifted},
                                                    {"energy", HullMapMethod::energy}};

std::string name_of(HullMapMethod method) {
  return std::find_if(kMethods.begin(), kMethods.end(), [&](const auto& m) { return m.second == method; })
      ->first;
}

/// The options as the user writes them.
struct Choice {
  std::string method = "progressive";
  std::string laplacian = "mean-value";
  std::string fitting = "normal";
  EnergyMapOptions energy;

  MapToHullOptions options() const {
    MapToHullOptions result{kMethods.at(method), energy};
    if (laplacian == "uniform") result.energy.laplacian = LaplacianKind::uniform;
    if (fitting == "closest-point") result.energy.fitting = HullFitting::closest_point;
    return result;
  }
};

void declare_options(CLI::App& app, Choice& choice) {
  app.add_option(
         "--method", choice.method,
         "progressive: one-to-one for every part without handles; lifted: its fallback, another way to a "
         "one-to-one map; energy: as in the paper, may fold")
      ->check(CLI::IsMember(kMethods))
      ->capture_default_str();
  app.add_option("--laplacian", choice.laplacian,
                 "energy: how much each neighbour of a vertex counts; uniform as in the paper's Fig. 8b")
      ->check(CLI::IsMember({"mean-value", "uniform"}))
      ->capture_default_str();
  app.add_option("--fitting", choice.fitting,
                 "energy: where on the hull a vertex is drawn; closest-point as in the paper's Fig. 9c")
      ->check(CLI::IsMember({"normal", "closest-point"}))
      ->capture_default_str();
  app.add_option("--global-weight", choice.energy.global_weight,
                 "energy: w_g, draws hull vertices to their places")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--first-convex-weight", choice.energy.first_convex_weight,
                 "energy: w_c of the first step, draws the other vertices to the hull")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--last-convex-weight", choice.energy.last_convex_weight, "energy: w_c of the last step")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--steps", choice.energy.steps, "energy: number of steps from the first w_c to the last")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
}

io::Json facts_of(const PartMapReport& report) {
  const bool by_energy = report.method == HullMapMethod::energy;
  io::Json facts{{"method", name_of(report.method)},
                 {"facets", report.facets},
                 {"folds", report.folds},
                 {"euler_characteristic", report.euler_characteristic},
                 {"degree", report.degree},
                 {"one_to_one", report.one_to_one}};
  if (by_energy) {
    facts["folds_before_repair"] = report.folds_before;
    facts["off_hull_before_projection"] = report.off_hull;
  } else {
    facts["distortion"] = report.distortion;
  }
  if (!report.remark.empty()) facts["remark"] = report.remark;
  return facts;
}

io::Json metrics_of(const MappedToHull& mapped) {
  io::Json parts = io::Json::object();
  int folds = 0;
  bool one_to_one = true;
  for (std::size_t k = 0; k < mapped.reports.size(); ++k) {
    const PartMapReport& report = mapped.reports[k];
    parts[mapped.map.hulled.model.segmentation.names[k]] = facts_of(report);
    folds += report.folds;
    one_to_one = one_to_one && report.one_to_one;
  }
  return {{"one_to_one", one_to_one}, {"folds", folds}, {"parts", parts}};
}

/// The parts without a certificate, the reason, and what to do; empty when there are none.
std::string uncertified(const MappedToHull& mapped) {
  std::string text;
  for (std::size_t k = 0; k < mapped.reports.size(); ++k) {
    const PartMapReport& report = mapped.reports[k];
    if (report.one_to_one) continue;
    text += (text.empty() ? "part \"" : "; part \"") + mapped.map.hulled.model.segmentation.names[k] + "\" ";
    if (!report.remark.empty()) text += report.remark + "; it ";
    text += "has " + std::to_string(report.folds) + " folded facets and covers its hull " +
            std::to_string(std::lround(report.degree)) + " times";
    if (report.remark.empty()) text += ", as the paper's energy may: take --method progressive";
  }
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Command command("map-to-hull", "Map every part of a model onto its own convex hull.",
                       "map-to-hull cat.hull.ply -o cat.hullmap.ply");
  const std::string& input = command.input("model", "Model with hulls, as hull writes it");
  command.output();
  Choice choice;
  declare_options(command.options(), choice);
  command.certificate();
  return command.run(argc, argv, [&] {
    const io::Document document = command.read(input, {"hull"});
    const MappedToHull mapped =
        command.about(input, [&] { return map_to_hull(io::read_hulled_model(document), choice.options()); });
    command.check_certificate(uncertified(mapped));
    command.write(io::to_document(mapped.map), {&document}, metrics_of(mapped));
  });
}
