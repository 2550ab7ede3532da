#include "mapping/loop_turns.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "mapping/parallel_parts.h"
#include "mapping/part_crossing.h"

namespace partwise {
namespace {

constexpr int kTurns = 8;
constexpr int kRefinements = 2;  ///< each halves the step
/// Strains that differ by less say nothing: so much is lost to how finely the parts are cut.
constexpr double kClearStrain = 0.02;
constexpr double kClearDistance = 1.25;  ///< ratio

class Turning {
 public:
  Turning(const ModelPair& pair, const HullMap& source, const HullMap& target)
      : pair_(pair), source_(source), target_(target), alignment_(align_models(pair)) {}

  /// Tries turns of one curve, the others being as in `turns`, which has the chosen one then.
  LoopShift choose(const CurvePair& curve, LoopShift shift, CurveTurns& turns) const {
    std::vector<double> shifts;
    for (int i = 0; i < kTurns; ++i) shifts.push_back(shift.shift + static_cast<double>(i) / kTurns);
    const std::vector<double> strains = strain(curve, shifts, turns);
    if (!std::isfinite(strains[0])) return shift;
    const auto best =
        static_cast<std::size_t>(std::min_element(strains.begin(), strains.end()) - strains.begin());
    const std::size_t chosen = strains[best] < strains[0] - kClearStrain ? best : 0;
    shift.shift = shifts[chosen];
    shift.strain = strains[chosen];
    for (std::size_t i = 0; i < shifts.size(); ++i) {
      if (i == chosen || (shift.rival_strain && strains[i] >= *shift.rival_strain)) continue;
      shift.rival_shift = shifts[i] - std::floor(shifts[i]);
      shift.rival_strain = strains[i];
    }
    if (chosen != 0) refine(curve, shift, turns);
    shift.shift -= std::floor(shift.shift);
    turns[curve.source_curve] = shift.shift;
    return shift;
  }

 private:
  std::vector<int> beside(const CurvePair& curve) const {
    const BoundaryCurve& there = pair_.target.segmentation.curves[curve.target_curve];
    if (there.right == kOutside) return {there.left};
    return {there.left, there.right};
  }

  void refine(const CurvePair& curve, LoopShift& shift, const CurveTurns& turns) const {
    double step = 0.5 / kTurns;
    for (int i = 0; i < kRefinements; ++i, step /= 2) {
      const std::vector<double> shifts{shift.shift - step, shift.shift + step};
      const std::vector<double> strains = strain(curve, shifts, turns);
      const std::size_t better = strains[0] < strains[1] ? 0 : 1;
      if (strains[better] >= *shift.strain) continue;
      shift.shift = shifts[better];
      shift.strain = strains[better];
    }
  }

  /// Per shift: strain of the parts beside the curve together, over the area of the smaller one, so that a
  /// leg's turn shows beside a large body.
  std::vector<double> strain(const CurvePair& curve, const std::vector<double>& shifts,
                             CurveTurns turns) const {
    const std::vector<int> parts = beside(curve);
    std::vector<BoundaryCorrespondence> boundaries;
    for (const double shift : shifts) {
      turns[curve.source_curve] = shift - std::floor(shift);
      boundaries.push_back(match_boundaries(pair_, turns));
    }
    std::vector<double> strains(shifts.size() * parts.size()), areas(strains.size());
    for_each_part(static_cast<int>(strains.size()), [&](int i) {
      const int k = parts[i % parts.size()];
      const PartToHull part(pair_, source_, target_, boundaries[i / parts.size()].placements, k, alignment_);
      areas[i] = part.area();
      strains[i] = part.strain() * part.area();
    });
    std::vector<double> sums(shifts.size(), 0.0);
    const double smallest = *std::min_element(areas.begin(), areas.end());
    for (std::size_t i = 0; i < strains.size(); ++i) sums[i / parts.size()] += strains[i] / smallest;
    return sums;
  }

  const ModelPair& pair_;
  const HullMap &source_, &target_;
  const Eigen::Affine3d alignment_;
};

}  // namespace

BoundaryCorrespondence choose_turns(const ModelPair& pair, const HullMap& source, const HullMap& target,
                                    BoundaryCorrespondence boundary) {
  const Turning turning(pair, source, target);
  CurveTurns turns;
  std::map<int, LoopShift> chosen;
  for (const CurveCorrespondence& curve : boundary.curves) {
    if (!curve.shift) continue;
    chosen[curve.curves.source_curve] = turning.choose(curve.curves, *curve.shift, turns);
  }
  if (chosen.empty()) return boundary;
  boundary = match_boundaries(pair, turns);
  for (CurveCorrespondence& curve : boundary.curves) {
    const auto found = chosen.find(curve.curves.source_curve);
    if (found == chosen.end()) continue;
    const LoopShift& turn = found->second;
    curve.shift->strain = turn.strain;
    curve.shift->rival_shift = turn.rival_shift;
    curve.shift->rival_strain = turn.rival_strain;
  }
  return boundary;
}

bool is_uncertain(const LoopShift& shift) {
  if (shift.strain) return *shift.rival_strain < *shift.strain + kClearStrain;
  return shift.other_rms_distance <= kClearDistance * shift.rms_distance;
}

}  // namespace partwise
