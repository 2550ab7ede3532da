#include "mapping/hull_to_hull.h"

#include <cmath>
#include <utility>

#include "mapping/parallel_parts.h"
#include "mapping/part_crossing.h"

namespace partwise {
namespace {

/// A turn that is hardly better than another one deserves a word.
void warn_of_uncertain_turns(const ModelPair& pair, HullToHull& result) {
  for (const CurveCorrespondence& curve : result.boundary.curves) {
    if (!curve.shift || curve.shift->other_rms_distance > 1.25 * curve.shift->rms_distance) continue;
    const Segmentation& target = pair.target.segmentation;
    const BoundaryCurve& there = target.curves[curve.curves.target_curve];
    const std::string other =
        there.right == kOutside ? "the mesh's boundary" : "'" + target.names[there.right] + "'";
    result.warnings.push_back("how the boundary between '" + target.names[there.left] + "' and " + other +
                              " is turned is uncertain: give both models an anchor there");
  }
}

void warn_of_parts(HullToHull& result) {
  for (const PartCrossing& part : result.parts) {
    if (!part.markers_held) {
      result.warnings.push_back("the markers of part '" + part.name +
                                "' could not be reached without folds: they were let go");
    }
    if (part.folds > 0) {
      result.warnings.push_back("part '" + part.name + "' has " + std::to_string(part.folds) +
                                " folded facets on the target's hull");
    }
  }
}

}  // namespace

HullToHull map_hull_to_hull(const HullMap& source, const HullMap& target) {
  const ModelPair pair = pair_models(source.hulled.model, target.hulled.model);
  HullToHull result{{pair.source, target, {}, {}, {}, pair.markers}, match_boundaries(pair), {}, {}, {}};
  result.warnings = pair.warnings;
  result.warnings.insert(result.warnings.end(), result.boundary.warnings.begin(),
                         result.boundary.warnings.end());
  const int parts = pair.target.segmentation.part_count();
  const Eigen::Affine3d alignment = align_models(pair);
  std::vector<PartToHull::Result> mapped(parts);
  for_each_part(parts, [&](int k) {
    const Eigen::Matrix3d upright = align_around(pair, {k}, alignment).linear();
    const PartToHull part(pair, source, target, result.boundary.placements, k,
                          upright / std::cbrt(upright.determinant()));
    mapped[k] = part.run();
  });

  CrossMap& map = result.map;
  map.boundary = result.boundary.placements;
  std::vector<std::size_t> next_marker(parts, 0);
  const double l = pair.target.mesh.diagonal();
  for (const MarkerConstraint& marker : pair.marker_constraints) {
    const double distance = mapped[marker.part].marker_distances[next_marker[marker.part]++];
    result.markers.push_back({pair.markers[marker.pair].name, distance / l});
  }
  for (int k = 0; k < parts; ++k) {
    map.source_parts.push_back(source.hulled.parts[pair.source_part[k]]);
    map.images.push_back(std::move(mapped[k].images));
    result.parts.push_back(mapped[k].crossing);
  }
  warn_of_uncertain_turns(pair, result);
  warn_of_parts(result);
  return result;
}

}  // namespace partwise
