#include "mapping/pin_on_hull.h"

#include <algorithm>

#include "mapping/split_chords.h"
#include "mapping/untangle_on_hull.h"

namespace partwise {
namespace {

constexpr double kFirstPull = 1e-2, kLastPull = 1e6, kPullGrowth = 100;
constexpr int kIterationsPerPull = 6, kIterationsAtLastPull = 10;

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

}  // namespace

PinnedMap pin_on_hull(const TriMesh& mesh, const std::vector<double>& vertex_weights, const StarHull& hull,
                      const Points& start, const std::vector<Pin>& pins,
                      const std::vector<std::array<int, 2>>& kept) {
  std::vector<bool> fixed(mesh.vertex_count(), false);
  for (const Pin& pin : pins) fixed[pin.vertex] = true;
  const SplitMesh split = split_chords(mesh, fixed, kept);
  std::vector<double> weights = vertex_weights;
  Points images = start;
  extend_to_split(split, weights, images);
  fixed.resize(images.size(), false);

  HullRelaxationOptions options;
  options.pulls = pins;
  options.most_iterations = kIterationsPerPull;
  for (options.pull_weight = kFirstPull; options.pull_weight <= kLastPull * 1.5;
       options.pull_weight *= kPullGrowth) {
    if (options.pull_weight * kPullGrowth > kLastPull * 1.5) options.most_iterations = kIterationsAtLastPull;
    images = relax_on_hull(split.mesh, weights, hull, images, {}, options).images;
    if (pins.empty()) break;
  }
  PinnedMap result;
  result.pulled_distance = largest_distance(pins, images) / bounding_box_diagonal(images);

  for (const Pin& pin : pins) images[pin.vertex] = pin.goal;
  if (count_folds(split.mesh, images) > 0) {
    images = untangle_on_hull(split.mesh, hull, images, fixed).images;
  }
  if (count_folds(split.mesh, images) == 0) {
    HullRelaxation relaxed = relax_on_hull(split.mesh, weights, hull, images, fixed, {});
    images = std::move(relaxed.images);
    result.distortion = relaxed.distortion;
  }
  images.resize(mesh.vertex_count());
  for (const Pin& pin : pins) images[pin.vertex] = pin.goal;  // to the bit, after projections
  result.folds = count_folds(mesh, images);
  result.images = std::move(images);
  return result;
}

}  // namespace partwise
