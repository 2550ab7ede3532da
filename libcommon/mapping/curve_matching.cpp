#include "mapping/curve_matching.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "error.h"

namespace partwise {
namespace {

std::string side_name(const Segmentation& target, int part) {
  return part == kOutside ? "the mesh's boundary" : "'" + target.names[part] + "'";
}

[[noreturn]] void refuse(const Segmentation& target, int left, int right, const std::string& why) {
  throw InputError("the boundaries between " + side_name(target, left) + " and " + side_name(target, right) +
                   " do not correspond: " + why +
                   "; run segment --check on the two models, then change a sketch");
}

/// An arc of a model in one of its two directions.
struct Dart {
  int curve = 0;
  bool backward = false;

  auto operator<=>(const Dart&) const = default;
  Dart opposite() const { return {curve, !backward}; }
};

/// The arcs of one model as a map of darts around cross points; parts in the target's numbering.
class ArcNetwork {
 public:
  template <class Renumber>
  ArcNetwork(const Segmentation& segmentation, Renumber in_target) : segmentation_(segmentation) {
    for (std::size_t c = 0; c < segmentation.curves.size(); ++c) {
      const BoundaryCurve& curve = segmentation.curves[c];
      sides_.push_back({in_target(curve.left), in_target(curve.right)});
      if (curve.closed) continue;
      for (const bool backward : {false, true}) {
        const Dart dart{static_cast<int>(c), backward};
        darts_.push_back(dart);
        leaving_[{start(dart), right(dart)}] = dart;
        ++degree_[start(dart)];
      }
    }
  }

  const std::vector<Dart>& darts() const { return darts_; }
  int left(const Dart& d) const { return sides_[d.curve][d.backward ? 1 : 0]; }
  int right(const Dart& d) const { return sides_[d.curve][d.backward ? 0 : 1]; }
  int start(const Dart& d) const {
    const auto& vertices = segmentation_.curves[d.curve].vertices;
    return d.backward ? vertices.back() : vertices.front();
  }
  int degree(const Dart& d) const { return degree_.at(start(d)); }
  /// The next dart around the start, counterclockwise: the one with this dart's left part on its right.
  Dart next(const Dart& d) const { return leaving_.at({start(d), left(d)}); }

 private:
  const Segmentation& segmentation_;
  std::vector<std::array<int, 2>> sides_;
  std::vector<Dart> darts_;
  std::map<std::pair<int, int>, Dart> leaving_;
  std::map<int, int> degree_;
};

using DartMap = std::map<Dart, Dart>;

/// Follows both networks from a pair of darts; none when they differ.
std::optional<DartMap> follow(const ArcNetwork& source, const ArcNetwork& target, Dart s, Dart t) {
  DartMap image;
  std::set<Dart> taken;
  std::vector<std::pair<Dart, Dart>> open{{s, t}};
  while (!open.empty()) {
    std::tie(s, t) = open.back();
    open.pop_back();
    if (const auto known = image.find(s); known != image.end()) {
      if (known->second != t) return std::nullopt;
      continue;
    }
    const bool alike = source.left(s) == target.left(t) && source.right(s) == target.right(t) &&
                       source.degree(s) == target.degree(t);
    if (!alike || !taken.insert(t).second) return std::nullopt;
    image[s] = t;
    open.push_back({s.opposite(), t.opposite()});
    open.push_back({source.next(s), target.next(t)});
  }
  return image;
}

class CurveMatcher {
 public:
  CurveMatcher(const ModelPair& pair, const Eigen::Affine3d& alignment);
  void match_arcs();
  void match_loops();
  std::vector<CurvePair> result() const;

 private:
  double cost(int source_curve, int target_curve) const;
  std::optional<DartMap> best_image(const ArcNetwork& source, const ArcNetwork& target,
                                    const Dart& from) const;
  void assign(const std::vector<int>& sources, const std::vector<int>& targets);

  const ModelPair& pair_;
  const Segmentation& source_;
  const Segmentation& target_;
  Points source_centres_, target_centres_;
  std::vector<std::pair<std::vector<int>, std::vector<int>>> landmarks_;  ///< curves each landmark lies on
  std::vector<std::optional<CurvePair>> found_;
  std::vector<bool> target_taken_;
};

/// Curves through each vertex.
std::map<int, std::vector<int>> curves_by_vertex(const Segmentation& segmentation) {
  std::map<int, std::vector<int>> curves;
  for (std::size_t c = 0; c < segmentation.curves.size(); ++c) {
    for (const int v : segmentation.curves[c].vertices) curves[v].push_back(static_cast<int>(c));
  }
  return curves;
}

CurveMatcher::CurveMatcher(const ModelPair& pair, const Eigen::Affine3d& alignment)
    : pair_(pair),
      source_(pair.source.segmentation),
      target_(pair.target.segmentation),
      found_(source_.curves.size()),
      target_taken_(target_.curves.size(), false) {
  for (const BoundaryCurve& c : source_.curves) {
    source_centres_.push_back(alignment * curve_centre(pair.source.mesh, c));
  }
  for (const BoundaryCurve& c : target_.curves) target_centres_.push_back(curve_centre(pair.target.mesh, c));
  auto on_source = curves_by_vertex(source_), on_target = curves_by_vertex(target_);
  for (const AnchorPair& anchor : pair.anchors) {
    landmarks_.push_back({on_source[anchor.source_vertex], on_target[anchor.target_vertex]});
  }
}

/// Squared distance after alignment over the target's squared diagonal; a landmark that would be torn apart
/// costs more than any distance.
double CurveMatcher::cost(int source_curve, int target_curve) const {
  double torn = 0;
  for (const auto& [on_source, on_target] : landmarks_) {
    const bool there = std::count(on_source.begin(), on_source.end(), source_curve) > 0;
    if (there && !std::count(on_target.begin(), on_target.end(), target_curve)) torn += 1e6;
  }
  const double l = pair_.target.mesh.diagonal();
  return torn + (source_centres_[source_curve] - target_centres_[target_curve]).squaredNorm() / (l * l);
}

std::optional<DartMap> CurveMatcher::best_image(const ArcNetwork& source, const ArcNetwork& target,
                                                const Dart& from) const {
  std::optional<DartMap> best;
  double lowest = std::numeric_limits<double>::infinity();
  for (const Dart& to : target.darts()) {
    if (target_taken_[to.curve]) continue;
    std::optional<DartMap> image = follow(source, target, from, to);
    if (!image) continue;
    double sum = 0;
    for (const auto& [s, t] : *image) sum += cost(s.curve, t.curve);
    if (sum < lowest) {
      lowest = sum;
      best = std::move(image);
    }
  }
  return best;
}

void CurveMatcher::match_arcs() {
  const ArcNetwork source(source_, [&](int part) { return pair_.in_target(part); });
  const ArcNetwork target(target_, [](int part) { return part; });
  for (const Dart& from : source.darts()) {
    if (found_[from.curve]) continue;
    const auto image = best_image(source, target, from);
    if (!image) {
      refuse(target_, source.left(from), source.right(from),
             "the source's arcs meet others than the target's");
    }
    for (const auto& [s, t] : *image) {
      if (s.backward) continue;
      found_[s.curve] = CurvePair{s.curve, t.curve, t.backward};
      target_taken_[t.curve] = true;
    }
  }
  for (const Dart& left_over : target.darts()) {
    if (target_taken_[left_over.curve]) continue;
    refuse(target_, target.left(left_over), target.right(left_over), "the target has more arcs");
  }
}

void CurveMatcher::assign(const std::vector<int>& sources, const std::vector<int>& targets) {
  std::vector<std::tuple<double, int, int>> costs;
  for (const int s : sources) {
    for (const int t : targets) costs.emplace_back(cost(s, t), s, t);
  }
  std::sort(costs.begin(), costs.end());
  for (const auto& [value, s, t] : costs) {
    if (found_[s] || target_taken_[t]) continue;
    const bool reversed = pair_.in_target(source_.curves[s].left) != target_.curves[t].left;
    found_[s] = CurvePair{s, t, reversed};
    target_taken_[t] = true;
  }
}

void CurveMatcher::match_loops() {
  using Sides = std::pair<int, int>;
  std::map<Sides, std::array<std::vector<int>, 2>> groups;
  for (std::size_t c = 0; c < source_.curves.size(); ++c) {
    const BoundaryCurve& curve = source_.curves[c];
    if (!curve.closed) continue;
    const int left = pair_.in_target(curve.left), right = pair_.in_target(curve.right);
    const bool in_order = right == kOutside || left < right;
    groups[in_order ? Sides(left, right) : Sides(right, left)][0].push_back(static_cast<int>(c));
  }
  for (std::size_t c = 0; c < target_.curves.size(); ++c) {
    const BoundaryCurve& curve = target_.curves[c];
    if (curve.closed) groups[{curve.left, curve.right}][1].push_back(static_cast<int>(c));
  }
  for (const auto& [sides, loops] : groups) {
    if (loops[0].size() != loops[1].size()) {
      refuse(target_, sides.first, sides.second,
             "the source has " + std::to_string(loops[0].size()) + " closed curves there, the target " +
                 std::to_string(loops[1].size()));
    }
    assign(loops[0], loops[1]);
  }
}

std::vector<CurvePair> CurveMatcher::result() const {
  std::vector<CurvePair> pairs;
  for (const auto& found : found_) pairs.push_back(*found);
  return pairs;
}

}  // namespace

std::vector<CurvePair> match_curves(const ModelPair& pair, const Eigen::Affine3d& alignment) {
  CurveMatcher matcher(pair, alignment);
  matcher.match_arcs();
  matcher.match_loops();
  return matcher.result();
}

std::vector<int> walked(const BoundaryCurve& curve, bool reversed) {
  std::vector<int> vertices = curve.vertices;
  if (reversed) std::reverse(curve.closed ? vertices.begin() + 1 : vertices.begin(), vertices.end());
  return vertices;
}

Vec3 curve_centre(const TriMesh& mesh, const BoundaryCurve& curve) {
  const std::size_t n = curve.vertices.size();
  Vec3 sum = Vec3::Zero();
  double walked_length = 0;
  for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < n; ++i) {
    const Vec3& a = mesh.point(curve.vertices[i]);
    const Vec3& b = mesh.point(curve.vertices[(i + 1) % n]);
    const double length = (b - a).norm();
    if (!curve.closed && walked_length + length >= curve.length / 2 && length > 0) {
      return a + (curve.length / 2 - walked_length) / length * (b - a);
    }
    walked_length += length;
    sum += length * (a + b) / 2;
  }
  return walked_length > 0 ? Vec3(sum / walked_length) : mesh.point(curve.vertices.front());
}

}  // namespace partwise
