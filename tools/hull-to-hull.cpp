#include <algorithm>
#include <cmath>

#include "cli/command.h"
#include "io/stage_documents.h"
#include "mapping/hull_to_hull.h"

namespace {

using namespace partwise;

io::Json metrics_of(const HullToHull& result) {
  io::Json parts = io::Json::object(), markers = io::Json::object(), turns = io::Json::array();
  int folds = 0;
  bool one_to_one = true;
  double farthest = 0;
  for (const PartCrossing& part : result.parts) {
    parts[part.name] = {{"source_folds", part.source_folds},
                        {"folds_before", part.folds_before},
                        {"folds", part.folds},
                        {"locked_folds", part.locked_folds},
                        {"degree", part.degree},
                        {"one_to_one", part.one_to_one},
                        {"distortion", part.distortion},
                        {"euler_characteristic", part.euler_characteristic},
                        {"released_markers", part.released_markers}};
    folds += part.folds;
    one_to_one = one_to_one && part.one_to_one;
  }
  for (const MarkerDistance& marker : result.markers) {
    markers[marker.name] = marker.distance;
    farthest = std::max(farthest, marker.distance);
  }
  const Segmentation& target = result.map.target.hulled.model.segmentation;
  for (const CurveCorrespondence& curve : result.boundary.curves) {
    if (!curve.shift) continue;
    const BoundaryCurve& there = target.curves[curve.curves.target_curve];
    turns.push_back({{"left", target.names[there.left]},
                     {"right", there.right == kOutside ? "outside" : target.names[there.right]},
                     {"shift", curve.shift->shift},
                     {"rms_distance", curve.shift->rms_distance},
                     {"other_shift", curve.shift->other_shift},
                     {"other_rms_distance", curve.shift->other_rms_distance}});
    if (!curve.shift->strain) continue;
    turns.back().update({{"strain", *curve.shift->strain},
                         {"rival_shift", curve.shift->rival_shift},
                         {"rival_strain", *curve.shift->rival_strain}});
  }
  return {{"one_to_one", one_to_one},
          {"folds", folds},
          {"parts", parts},
          {"marker_distances", markers},
          {"marker_distance_max", farthest},
          {"turned_curves", turns}};
}

/// Why a part has no certificate, and what to do.
std::string reason(const PartCrossing& part) {
  if (part.euler_characteristic != 2) return "has a handle: cut it into two parts";
  if (part.source_folds > 0) {
    return "folds already on its own hull (" + std::to_string(part.source_folds) +
           " facets): see what map-to-hull said of it";
  }
  std::string text = "keeps " + std::to_string(part.folds) + " folded facets";
  if (part.locked_folds > 0) {
    text += ", " + std::to_string(part.locked_folds) +
            " of them with all corners on its boundary, which bends the other way on the target: draw the "
            "boundary "
            "elsewhere, or give anchors";
  } else if (part.folds == 0) {
    text = "covers its hull " + std::to_string(std::lround(part.degree)) + " times";
  } else {
    text += ": look at its anchors and markers on both models";
  }
  return text;
}

/// The parts without a certificate; empty when there are none.
std::string uncertified(const HullToHull& result) {
  std::string text;
  for (const PartCrossing& part : result.parts) {
    if (part.one_to_one) continue;
    text += (text.empty() ? "part \"" : "; part \"") + part.name + "\" " + reason(part);
  }
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  cli::Command command("hull-to-hull",
                       "Map the source's parts onto the target's hulls: boundaries by arc length between "
                       "anchors, markers on markers.",
                       "hull-to-hull cat.hullmap.ply lion.hullmap.ply -o cat-lion.crossmap.ply");
  const std::string& source_path = command.input("source", "Hull maps of the source", false);
  const std::string& target_path = command.input("target", "Hull maps of the target", false);
  command.output();
  HullToHullOptions options;
  std::string method = "pull";
  command.options()
      .add_option("--method", method,
                  "pull: by pulls that turn no facet over; energy: as in the paper, may fold")
      ->check(CLI::IsMember({"pull", "energy"}))
      ->capture_default_str();
  command.certificate();
  return command.run(argc, argv, [&] {
    const io::Document source = command.read(source_path, {"hullmap"});
    const io::Document target = command.read(target_path, {"hullmap"});
    const HullMap source_map = command.about(source_path, [&] { return io::read_hull_map(source); });
    const HullMap target_map = command.about(target_path, [&] { return io::read_hull_map(target); });
    options.method = method == "energy" ? CrossMethod::energy : CrossMethod::pull;
    const HullToHull result = command.about(source_path + " and " + target_path, [&] {
      return map_hull_to_hull(source_map, target_map, options);
    });
    for (const std::string& warning : result.warnings) command.warn(warning);
    command.check_certificate(uncertified(result));
    command.write(io::to_document(result.map), {&source, &target}, metrics_of(result));
  });
}
