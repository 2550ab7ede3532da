#include "mapping/hull_to_hull.h"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <utility>

#include "error.h"
#include "mapping/loop_turns.h"
#include "mapping/parallel_parts.h"
#include "mapping/part_crossing.h"
#include "segmentation/compatibility.h"

namespace partwise {
namespace {

/// The landmarks of `landmarks` that `others` name too.
template <class Landmark>
std::vector<Landmark> shared(std::vector<Landmark> landmarks, const std::vector<Landmark>& others) {
  std::erase_if(landmarks, [&](const Landmark& landmark) {
    return std::none_of(others.begin(), others.end(),
                        [&](const Landmark& other) { return other.name == landmark.name; });
  });
  return landmarks;
}

/// Landmarks on one model only are no reason to refuse: they are not used, and a warning says so.
void require_compatible(const SegmentedModel& source, const SegmentedModel& target) {
  SegmentedModel first = source, second = target;
  first.markers = shared(source.markers, target.markers);
  first.anchors = shared(source.anchors, target.anchors);
  second.markers = shared(target.markers, source.markers);
  second.anchors = shared(target.anchors, source.anchors);
  const std::vector<std::string> differences = compare_segmentations(first, second);
  if (differences.empty()) return;
  std::string text = "the models' parts do not correspond (first model: source, second: target)";
  for (const std::string& difference : differences) text += "; " + difference;
  throw InputError(text + ". Correct a sketch; segment --check compares two segmentations");
}

/// A turn that is hardly better than another one deserves a word.
void warn_of_uncertain_turns(const ModelPair& pair, HullToHull& result) {
  for (const CurveCorrespondence& curve : result.boundary.curves) {
    if (!curve.shift || !is_uncertain(*curve.shift)) continue;
    const Segmentation& target = pair.target.segmentation;
    const BoundaryCurve& there = target.curves[curve.curves.target_curve];
    const std::string other =
        there.right == kOutside ? "the mesh's boundary" : "'" + target.names[there.right] + "'";
    result.warnings.push_back("how the boundary between '" + target.names[there.left] + "' and " + other +
                              " is turned is uncertain: give both models an anchor there");
  }
}

void warn_of_markers(HullToHull& result) {
  for (const MarkerDistance& marker : result.markers) {
    if (marker.held) continue;
    std::ostringstream text;
    text << "marker '" << marker.name << "' could not be reached without folds: it stays "
         << std::setprecision(2) << 100 * marker.distance
         << " % of the target's diagonal away; look at its place, and at part boundaries near it, on both "
            "models";
    result.warnings.push_back(text.str());
  }
}

}  // namespace

HullToHull map_hull_to_hull(const HullMap& source, const HullMap& target, const HullToHullOptions& options) {
  require_compatible(source.hulled.model, target.hulled.model);
  const ModelPair pair = pair_models(source.hulled.model, target.hulled.model);
  HullToHull result{{pair.source, target, {}, {}, {}, pair.markers},
                    choose_turns(pair, source, target, match_boundaries(pair)),
                    {},
                    {},
                    {}};
  result.warnings = pair.warnings;
  result.warnings.insert(result.warnings.end(), result.boundary.warnings.begin(),
                         result.boundary.warnings.end());
  const int parts = pair.target.segmentation.part_count();
  const Eigen::Affine3d alignment = align_models(pair);
  std::vector<PartToHull::Result> mapped(parts);
  for_each_part(parts, [&](int k) {
    mapped[k] = PartToHull(pair, source, target, result.boundary.placements, k, alignment).run(options);
  });

  CrossMap& map = result.map;
  map.boundary = result.boundary.placements;
  std::vector<std::size_t> next_marker(parts, 0);
  const double l = pair.target.mesh.diagonal();
  for (const MarkerConstraint& marker : pair.marker_constraints) {
    const std::size_t i = next_marker[marker.part]++;
    const std::string& name = pair.markers[marker.pair].name;
    PartToHull::Result& part = mapped[marker.part];
    result.markers.push_back({name, part.marker_distances[i] / l, part.marker_held[i]});
    if (!part.marker_held[i]) part.crossing.released_markers.push_back(name);
  }
  for (int k = 0; k < parts; ++k) {
    map.source_parts.push_back(source.hulled.parts[pair.source_part[k]]);
    map.images.push_back(std::move(mapped[k].images));
    result.parts.push_back(mapped[k].crossing);
  }
  warn_of_uncertain_turns(pair, result);
  warn_of_markers(result);
  return result;
}

}  // namespace partwise
