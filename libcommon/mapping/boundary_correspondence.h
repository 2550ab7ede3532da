#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mapping/curve_matching.h"
#include "mapping/model_pair.h"

namespace partwise {

/// How a closed curve without anchors was turned, and what speaks for other turns.
struct LoopShift {
  double shift = 0;  ///< of the source's first vertex along the target's curve, in [0, 1) of its length
  double rms_distance = 0;  ///< after alignment, over the target's diagonal
  double other_shift = 0;   ///< of those at least 1/16 of the length away, the one with the least distance
  double other_rms_distance = 0;
  /// Distortion of the parts beside the curve drawn to their places, beyond that of isometries and over the
  /// smaller part's area; see choose_turns. Without value where that was not tried.
  std::optional<double> strain;
  double rival_shift = 0;  ///< of the other turns tried, the one with the least strain
  std::optional<double> rival_strain;
};

/// How one curve of the source goes to one of the target.
struct CurveCorrespondence {
  CurvePair curves;
  std::vector<std::string> anchors;  ///< in order along the target's curve
  std::optional<LoopShift> shift;    ///< closed curves without anchors only
};

/// Where every boundary vertex of the source lies on the target's boundary.
struct BoundaryCorrespondence {
  std::vector<CurveCorrespondence> curves;    ///< in the order of the source's curves
  std::vector<BoundaryPlacement> placements;  ///< ascending by source vertex
  std::vector<std::string> warnings;
};

/// Given turns: per curve of the source, LoopShift::shift.
using CurveTurns = std::map<int, double>;

/// Places the source's boundary vertices on the target's ([Wu11] 5.2): cross points on cross points, anchors
/// on anchors, the vertices between them at the same fraction of arc length on the two original meshes.
///
/// A closed curve with one anchor starts there. One without is turned as `turns` says, or else as the models
/// lie after a similarity alignment of what surrounds it (markers, anchors, centroids of parts).
/// Differs from [Wu11]: which asks for anchors on every closed curve; a good turn is found without.
/// \throws InputError when curves do not correspond, or naming anchors that lie between different parts or
/// come
///         in different orders along a curve.
BoundaryCorrespondence match_boundaries(const ModelPair& pair, const CurveTurns& turns = {});

}  // namespace partwise
