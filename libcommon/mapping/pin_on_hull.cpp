#include "mapping/pin_on_hull.h"

#include <algorithm>
#include <utility>

#include "mapping/split_chords.h"
#include "mapping/untangle_on_hull.h"

namespace partwise {
namespace {

constexpr double kFirstPull = 1e-2, kLastPull = 1e6;
constexpr double kPulledRounding = 0.1;  // between coarse and fine: one relaxation per pull
/// The last relaxation ends near its minimum, so that rounding on the way there does not show in the result.
constexpr double kSettled = 1e-4;
constexpr double kDrawingPull = 1e2;  // of what is drawn, once the pins are set: more would flatten facets

int count_folds(const TriMesh& mesh, const Points& images) {
  return static_cast<int>(std::count_if(mesh.facets().begin(), mesh.facets().end(), [&](const Facet& f) {
    const Vec3& p = images[f[0]];
    return !(p.dot((images[f[1]] - p).cross(images[f[2]] - p)) > 0);
  }));
}

double largest_distance(const std::vector<Pin>& pins, const Points& images) {
  double largest = 0;
  for (const Pin& pin : pins) largest = std::max(largest, (images[pin.vertex] - pin.goal).norm());
  return largest;
}

/// The split mesh's weights and start: an added vertex lies in the middle of its edge's image.
void extend_to_split(const SplitMesh& split, std::vector<double>& weights, Points& start) {
  for (const auto& [a, b] : split.split_edges) {
    weights.push_back(std::min(weights[a], weights[b]));
    start.push_back((start[a] + start[b]) / 2);
  }
}

/// Pulls of growing weight; the last relaxation takes longer.
Points pulled(const SplitMesh& split, const std::vector<double>& weights, const StarHull& hull, Points images,
              const std::vector<Pin>& pins, const PinOptions& options) {
  HullRelaxationOptions relaxation;
  relaxation.pulls = pins;
  relaxation.pulls.insert(relaxation.pulls.end(), options.drawn.begin(), options.drawn.end());
  relaxation.most_iterations = options.iterations_per_pull;
  relaxation.rounding = {kPulledRounding};
  for (relaxation.pull_weight = kFirstPull; relaxation.pull_weight <= kLastPull * 1.5;
       relaxation.pull_weight *= options.pull_growth) {
    const bool is_last = relaxation.pull_weight * options.pull_growth > kLastPull * 1.5;
    if (is_last) relaxation.most_iterations += 4;
    images = relax_on_hull(split.mesh, weights, hull, images, {}, relaxation).images;
    if (relaxation.pulls.empty()) break;
  }
  return images;
}

void set(const std::vector<Pin>& pins, Points& images) {
  for (const Pin& pin : pins) images[pin.vertex] = pin.goal;
}

/// Undoes folds, then relaxes with the fixed vertices in place; as it was when folds remain.
void settle(const TriMesh& mesh, const std::vector<double>& weights, const StarHull& hull,
            const std::vector<bool>& fixed, const std::vector<Pin>& drawn, PinnedMap& map) {
  if (count_folds(mesh, map.images) > 0) {
    map.images = untangle_on_hull(mesh, hull, map.images, fixed).images;
  }
  if (count_folds(mesh, map.images) > 0) return;
  HullRelaxationOptions relaxation;
  relaxation.pulls = drawn;
  relaxation.pull_weight = kDrawingPull;
  relaxation.least_decrease = kSettled;
  HullRelaxation relaxed = relax_on_hull(mesh, weights, hull, map.images, fixed, relaxation);
  map.images = std::move(relaxed.images);
  map.distortion = relaxed.distortion;
}

}  // namespace

PinnedMap pin_on_hull(const TriMesh& mesh, const std::vector<double>& vertex_weights, const StarHull& hull,
                      const Points& start, const std::vector<Pin>& pins,
                      const std::vector<std::array<int, 2>>& kept, const PinOptions& options) {
  std::vector<bool> fixed(mesh.vertex_count(), false);
  for (const Pin& pin : pins) fixed[pin.vertex] = true;
  const SplitMesh split = split_chords(mesh, fixed, kept);
  std::vector<double> weights = vertex_weights;
  PinnedMap result;
  result.images = start;
  extend_to_split(split, weights, result.images);
  fixed.resize(result.images.size(), false);

  result.images = pulled(split, weights, hull, std::move(result.images), pins, options);
  result.pulled_distance = largest_distance(pins, result.images) / bounding_box_diagonal(result.images);
  set(pins, result.images);
  settle(split.mesh, weights, hull, fixed, options.drawn, result);

  result.images.resize(mesh.vertex_count());
  set(pins, result.images);  // to the bit, after projections
  if (count_folds(mesh, result.images) > 0 && !split.split_edges.empty()) {
    // One-to-one with its chords bent, not yet with straight ones.
    fixed.resize(mesh.vertex_count());
    settle(mesh, vertex_weights, hull, fixed, options.drawn, result);
    set(pins, result.images);
  }
  result.folds = count_folds(mesh, result.images);
  return result;
}

}  // namespace partwise
