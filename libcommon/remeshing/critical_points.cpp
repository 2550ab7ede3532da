#include "remeshing/critical_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>
#include <string>
#include <utility>

#include "error.h"
#include "geometry/curvature.h"

namespace partwise {
namespace {

/// Removes vertices around a centre by their distance along edges; keeps its arrays between calls.
class RegionGrower {
 public:
  explicit RegionGrower(const TriMesh& mesh) : mesh_(mesh), distance_(mesh.vertex_count(), kUnreached) {}

  /// Marks all vertices within `radius` of `centre` as taken. Returns those that were not, ascending.
  std::vector<int> take(int centre, double radius, std::vector<bool>& taken) {
    std::vector<int> region;
    queue_.emplace(0.0, centre);
    distance_[centre] = 0;
    reached_.push_back(centre);
    while (!queue_.empty()) {
      const auto [distance, vertex] = queue_.top();
      queue_.pop();
      if (distance > distance_[vertex]) continue;
      if (!taken[vertex]) region.push_back(vertex);
      taken[vertex] = true;
      for (const auto neighbour : mesh_.half_edges().vv_range(OpenMesh::VertexHandle(vertex))) {
        relax(neighbour.idx(), distance + (mesh_.point(neighbour.idx()) - mesh_.point(vertex)).norm(),
              radius);
      }
    }
    for (const int vertex : reached_) distance_[vertex] = kUnreached;
    reached_.clear();
    std::sort(region.begin(), region.end());
    return region;
  }

 private:
  static constexpr double kUnreached = std::numeric_limits<double>::infinity();

  void relax(int vertex, double distance, double radius) {
    if (distance > radius || distance >= distance_[vertex]) return;
    if (distance_[vertex] == kUnreached) reached_.push_back(vertex);
    distance_[vertex] = distance;
    queue_.emplace(distance, vertex);
  }

  using Entry = std::pair<double, int>;
  const TriMesh& mesh_;
  std::vector<double> distance_;
  std::vector<int> reached_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

/// Vertices by descending |K|. Curvatures are compared after rounding to 9 digits of the largest, so that
/// equal vertices of a symmetric mesh keep their order when rounding errors change.
std::vector<int> by_curvature(const std::vector<double>& curvature) {
  double largest = 0;
  for (const double k : curvature) largest = std::max(largest, std::abs(k));
  auto rank = [&](int v) { return largest > 0 ? std::round(1e9 * std::abs(curvature[v]) / largest) : 0; };
  std::vector<int> order(curvature.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return rank(a) > rank(b); });
  return order;
}

/// One run of the selection; stops early, with limit + 1 points, when there are more than `limit`.
std::vector<CriticalPoint> select(const TriMesh& mesh, const std::vector<double>& curvature,
                                  const std::vector<int>& order, double radius_scale, int limit) {
  const double diagonal = mesh.diagonal();
  RegionGrower grower(mesh);
  std::vector<bool> taken(mesh.vertex_count(), false);
  std::vector<CriticalPoint> points;
  for (const int vertex : order) {
    if (taken[vertex]) continue;
    const double steepness = diagonal * std::abs(curvature[vertex]);
    const double radius = radius_scale < steepness * diagonal ? radius_scale / steepness : diagonal;
    points.push_back({vertex, curvature[vertex], radius});
    if (static_cast<int>(points.size()) > limit) break;
    points.back().region = grower.take(vertex, radius, taken);
  }
  return points;
}

int limit_of(const TriMesh& mesh, const CriticalPointOptions& options) {
  if (options.count < 0) {
    throw InputError("the number of critical points is " + std::to_string(options.count) +
                     "; give a positive number, or 0 for no bound of its own");
  }
  if (!(options.fraction > 0) || options.fraction > 1) {
    throw InputError("the fraction of critical points is " + std::to_string(options.fraction) +
                     "; give a number above 0 and at most 1");
  }
  const int share = std::max(1, static_cast<int>(options.fraction * mesh.vertex_count()));
  return options.count > 0 ? std::min(options.count, share) : share;
}

}  // namespace

CriticalPoints find_critical_points(const TriMesh& mesh, const CriticalPointOptions& options) {
  const int limit = limit_of(mesh, options);
  const std::vector<double> curvature = gaussian_curvature(mesh);
  const std::vector<int> order = by_curvature(curvature);
  auto fits = [&](const CriticalPoints& c) { return static_cast<int>(c.points.size()) <= limit; };
  auto run = [&](double scale) {
    return CriticalPoints{select(mesh, curvature, order, scale, limit), scale};
  };

  CriticalPoints best = run(1);
  if (fits(best)) return best;
  double low = 1, high = 2;
  constexpr int most_doublings = 60;
  for (int i = 0; i < most_doublings && !fits(best = run(high)); ++i) {
    low = high;
    high *= 2;
  }
  constexpr int bisections = 6;
  for (int i = 0; i < bisections && fits(best); ++i) {
    const double middle = std::sqrt(low * high);
    CriticalPoints trial = run(middle);
    if (fits(trial)) {
      best = std::move(trial);
      high = middle;
    } else {
      low = middle;
    }
  }
  // More components than points allowed: no radius suffices, the most curved ones stay.
  if (!fits(best)) best.points.resize(limit);
  return best;
}

CriticalPoints find_critical_points(const CompatibleMesh& mesh, const CriticalPointOptions& options) {
  CriticalPointOptions bounded = options;
  bounded.count = limit_of(mesh.source, options);
  return find_critical_points(mesh.target, bounded);
}

}  // namespace partwise
