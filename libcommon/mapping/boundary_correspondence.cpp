#include "mapping/boundary_correspondence.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "error.h"
#include "mapping/loop_shift.h"

namespace partwise {
namespace {

/// A curve of one model by arc length on its own mesh.
struct Chain {
  std::vector<int> vertices;
  std::vector<double> lengths;  ///< from the first vertex to each; for a closed curve one more, the whole
  bool closed = false;

  Chain(const TriMesh& mesh, const BoundaryCurve& curve, bool reversed)
      : vertices(walked(curve, reversed)), closed(curve.closed) {
    lengths.push_back(0);
    for (std::size_t i = 1; i < vertices.size() + (closed ? 1 : 0); ++i) {
      const int a = vertices[i - 1], b = vertices[i % vertices.size()];
      lengths.push_back(lengths.back() + (mesh.point(b) - mesh.point(a)).norm());
    }
  }
  double length() const { return lengths.back(); }
  int segment_count() const { return static_cast<int>(lengths.size()) - 1; }
  int vertex(int i) const { return vertices[i % vertices.size()]; }
  /// Position of a vertex in the chain, or -1.
  int find(int v) const {
    const auto found = std::find(vertices.begin(), vertices.end(), v);
    return found == vertices.end() ? -1 : static_cast<int>(found - vertices.begin());
  }
};

/// A point of the source's chain and of the target's that belong together, by arc length.
struct Knot {
  double source = 0;
  double target = 0;
  std::string name;
};

/// The place at arc length `s` of the target's chain; within rounding of a vertex it is the vertex.
BoundaryPlacement place(const Chain& target, double s, int source_vertex) {
  constexpr double kSnap = 1e-9;
  if (target.closed) s -= target.length() * std::floor(s / target.length());
  const auto after = std::upper_bound(target.lengths.begin() + 1, target.lengths.end() - 1, s);
  const int i = static_cast<int>(after - target.lengths.begin()) - 1;
  const double span = target.lengths[i + 1] - target.lengths[i];
  const double t = span > 0 ? std::clamp((s - target.lengths[i]) / span, 0.0, 1.0) : 0;
  const int a = target.vertex(i), b = target.vertex(i + 1);
  if (t < kSnap) return {source_vertex, a, a, 0};
  if (t > 1 - kSnap) return {source_vertex, b, b, 0};
  return {source_vertex, a, b, t};
}

class CurvePlacer {
 public:
  CurvePlacer(const ModelPair& pair, const CurvePair& curves, const Eigen::Affine3d& alignment)
      : pair_(pair),
        curves_(curves),
        alignment_(alignment),
        source_(pair.source.mesh, pair.source.segmentation.curves[curves.source_curve], curves.reversed),
        target_(pair.target.mesh, pair.target.segmentation.curves[curves.target_curve], false) {}

  CurveCorrespondence correspondence(const CurveTurns& turns);
  void place_vertices(std::map<int, BoundaryPlacement>& placements) const;
  std::vector<std::string> warnings;

 private:
  void find_anchors();
  void require_equal_order() const;
  LoopShift turn(const CurveTurns& turns) const;
  std::string where() const;

  const ModelPair& pair_;
  CurvePair curves_;
  const Eigen::Affine3d& alignment_;
  Chain source_, target_;
  std::vector<Knot> knots_;  ///< ascending along the source; the target's lengths ascend with them
};

std::string CurvePlacer::where() const {
  const Segmentation& target = pair_.target.segmentation;
  const BoundaryCurve& curve = target.curves[curves_.target_curve];
  const std::string other =
      curve.right == kOutside ? "the mesh's boundary" : "'" + target.names[curve.right] + "'";
  return "between '" + target.names[curve.left] + "' and " + other;
}

void CurvePlacer::find_anchors() {
  for (const AnchorPair& anchor : pair_.anchors) {
    const int s = source_.find(anchor.source_vertex), t = target_.find(anchor.target_vertex);
    if (s < 0 || t < 0) continue;
    const Knot knot{source_.lengths[s], target_.lengths[t], anchor.name};
    const auto twin = std::find_if(knots_.begin(), knots_.end(), [&](const Knot& k) {
      return k.source == knot.source || k.target == knot.target;
    });
    if (twin == knots_.end()) {
      knots_.push_back(knot);
    } else if (twin->source != knot.source || twin->target != knot.target) {
      const std::string twin_name = twin->name.empty() ? "a cross point" : "anchor '" + twin->name + "'";
      warnings.push_back("anchor '" + anchor.name + "' falls on " + twin_name +
                         " on one of the models only: not used");
    }
  }
  std::stable_sort(knots_.begin(), knots_.end(),
                   [](const Knot& a, const Knot& b) { return a.source < b.source; });
}

void CurvePlacer::require_equal_order() const {
  for (std::size_t i = 1; i < knots_.size(); ++i) {
    if (knots_[i].target > knots_[i - 1].target) continue;
    std::string names;
    for (const Knot& knot : knots_) {
      if (!knot.name.empty()) names += (names.empty() ? "'" : ", '") + knot.name + "'";
    }
    throw InputError("the anchors " + names + " " + where() +
                     " come in this order on the source but not on the target; correct a sketch");
  }
}

LoopShift CurvePlacer::turn(const CurveTurns& turns) const {
  const BoundaryCurve& curve = pair_.target.segmentation.curves[curves_.target_curve];
  const Eigen::Affine3d local = align_around(pair_, {curve.left, curve.right}, alignment_);
  Points source, target;
  for (const int v : source_.vertices) source.push_back(local * pair_.source.mesh.point(v));
  for (const int v : target_.vertices) target.push_back(pair_.target.mesh.point(v));
  const double l = pair_.target.mesh.diagonal();
  const auto given = turns.find(curves_.source_curve);
  return given == turns.end() ? best_shift(source, target, l) : given_shift(source, target, l, given->second);
}

CurveCorrespondence CurvePlacer::correspondence(const CurveTurns& turns) {
  CurveCorrespondence result{curves_, {}, std::nullopt};
  if (!source_.closed) {
    knots_ = {{0, 0, ""}, {source_.length(), target_.length(), ""}};
    find_anchors();
  } else {
    find_anchors();
    if (knots_.empty()) {
      result.shift = turn(turns);
      knots_.push_back({0, result.shift->shift * target_.length(), ""});
    }
    // Count the target's lengths from the first anchor on, over the chain's end, and close the round.
    for (Knot& knot : knots_) {
      if (knot.target < knots_.front().target) knot.target += target_.length();
    }
    knots_.push_back(
        {knots_.front().source + source_.length(), knots_.front().target + target_.length(), ""});
  }
  require_equal_order();
  for (const Knot& knot : knots_) {
    if (!knot.name.empty()) result.anchors.push_back(knot.name);
  }
  return result;
}

void CurvePlacer::place_vertices(std::map<int, BoundaryPlacement>& placements) const {
  for (std::size_t i = 0; i < source_.vertices.size(); ++i) {
    double s = source_.lengths[i];
    if (s < knots_.front().source) s += source_.length();
    const auto after = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, s,
                                        [](double value, const Knot& knot) { return value < knot.source; });
    const Knot& from = *(after - 1);
    const double fraction = (s - from.source) / (after->source - from.source);
    const double t = (1 - fraction) * from.target + fraction * after->target;
    placements[source_.vertices[i]] = place(target_, t, source_.vertices[i]);
  }
}

/// Anchors must lie on curves that belong together.
std::vector<std::string> check_anchors(const ModelPair& pair, const std::vector<CurvePair>& curves) {
  std::vector<std::string> warnings;
  auto on = [](const Segmentation& segmentation, int curve, int vertex) {
    const std::vector<int>& vertices = segmentation.curves[curve].vertices;
    return std::find(vertices.begin(), vertices.end(), vertex) != vertices.end();
  };
  for (const AnchorPair& anchor : pair.anchors) {
    const bool together = std::any_of(curves.begin(), curves.end(), [&](const CurvePair& c) {
      return on(pair.source.segmentation, c.source_curve, anchor.source_vertex) &&
             on(pair.target.segmentation, c.target_curve, anchor.target_vertex);
    });
    if (together) continue;
    const std::string text = "anchor '" + anchor.name + "' (vertex " + std::to_string(anchor.source_vertex) +
                             " of the source, " + std::to_string(anchor.target_vertex) +
                             " of the target) does not lie on corresponding boundary curves";
    if (!anchor.from_marker) throw InputError(text + "; move it in one of the sketches");
    warnings.push_back("marker" + text.substr(6) + ": not used there");
  }
  return warnings;
}

}  // namespace

BoundaryCorrespondence match_boundaries(const ModelPair& pair, const CurveTurns& turns) {
  const Eigen::Affine3d alignment = align_models(pair);
  const std::vector<CurvePair> curves = match_curves(pair, alignment);
  BoundaryCorrespondence result;
  result.warnings = check_anchors(pair, curves);
  std::map<int, BoundaryPlacement> placements;
  for (const CurvePair& c : curves) {
    CurvePlacer placer(pair, c, alignment);
    result.curves.push_back(placer.correspondence(turns));
    placer.place_vertices(placements);
    result.warnings.insert(result.warnings.end(), placer.warnings.begin(), placer.warnings.end());
  }
  for (const auto& [vertex, placement] : placements) result.placements.push_back(placement);
  return result;
}

}  // namespace partwise
