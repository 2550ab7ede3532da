#include "mapping/repair_folds.h"

#include <algorithm>
#include <array>

namespace partwise {
namespace {

constexpr std::array kRings{1, 2, 3, 5, 8, 12};  // how far around a fold vertices may move, try by try
constexpr int kRounds = 8;                       // of sweeps; folds are counted after each
constexpr int kSweeps = 8;                       // per round

bool is_folded(const Facet& f, const Points& p) {
  const Vec3& a = p[f[0]];
  return !(a.dot((p[f[1]] - a).cross(p[f[2]] - a)) > 0);
}

class FoldRepair {
 public:
  FoldRepair(const Facets& facets, const VertexWeights& weights, const Points& directions)
      : facets_(facets), weights_(weights), directions_(directions), facets_around_(directions.size()) {
    for (std::size_t f = 0; f < facets.size(); ++f) {
      for (const int v : facets[f]) facets_around_[v].push_back(static_cast<int>(f));
    }
  }

  Points run() {
    for (const int rings : kRings) {
      for (const std::vector<int>& region : regions(rings)) relax(region);
    }
    return directions_;
  }

 private:
  /// The vertices within so many edges of folded facets, connected ones together, each ascending.
  std::vector<std::vector<int>> regions(int rings) const {
    std::vector<bool> inside(directions_.size(), false);
    for (const Facet& f : facets_) {
      if (!is_folded(f, directions_)) continue;
      for (const int v : f) inside[v] = true;
    }
    for (int ring = 0; ring < rings; ++ring) {
      const std::vector<bool> before = inside;
      for (std::size_t v = 0; v < before.size(); ++v) {
        if (before[v]) for_each_neighbour(static_cast<int>(v), [&](int w, double) { inside[w] = true; });
      }
    }
    std::vector<std::vector<int>> found;
    for (std::size_t v = 0; v < inside.size(); ++v) {
      if (inside[v]) found.push_back(taken_out(inside, static_cast<int>(v)));
    }
    return found;
  }

  /// The vertices connected to `start` inside a region, which loses them.
  std::vector<int> taken_out(std::vector<bool>& inside, int start) const {
    std::vector<int> component{start};
    inside[start] = false;
    for (std::size_t next = 0; next < component.size(); ++next) {
      for_each_neighbour(component[next], [&](int w, double) {
        if (!inside[w]) return;
        inside[w] = false;
        component.push_back(w);
      });
    }
    std::sort(component.begin(), component.end());
    return component;
  }

  template <class Function>
  void for_each_neighbour(int vertex, Function f) const {
    for (VertexWeights::InnerIterator j(weights_, vertex); j; ++j) f(static_cast<int>(j.col()), j.value());
  }

  int folds_around(const std::vector<int>& vertices) const {
    std::vector<int> folded;
    for (const int v : vertices) {
      for (const int f : facets_around_[v]) {
        if (is_folded(facets_[f], directions_)) folded.push_back(f);
      }
    }
    std::sort(folded.begin(), folded.end());
    return static_cast<int>(std::unique(folded.begin(), folded.end()) - folded.begin());
  }

  void sweep(const std::vector<int>& vertices) {
    for (const int v : vertices) {
      Vec3 mean = Vec3::Zero();
      for_each_neighbour(v, [&](int w, double weight) { mean += weight * directions_[w].normalized(); });
      if (mean.norm() > 1e-6) directions_[v] = mean.normalized();
    }
  }

  /// Keeps the first round with the fewest folds, if that is fewer than at the start.
  void relax(const std::vector<int>& region) {
    const auto positions = [&] {
      Points kept;
      for (const int v : region) kept.push_back(directions_[v]);
      return kept;
    };
    int fewest = folds_around(region);
    Points best = positions();
    for (int round = 0; round < kRounds && fewest > 0; ++round) {
      for (int i = 0; i < kSweeps; ++i) sweep(region);
      const int folds = folds_around(region);
      if (folds >= fewest) continue;
      fewest = folds;
      best = positions();
    }
    for (std::size_t i = 0; i < region.size(); ++i) directions_[region[i]] = best[i];
  }

  const Facets& facets_;
  const VertexWeights& weights_;
  Points directions_;
  std::vector<std::vector<int>> facets_around_;
};

}  // namespace

Points repair_folds(const Facets& facets, const VertexWeights& weights, const Points& directions) {
  return FoldRepair(facets, weights, directions).run();
}

}  // namespace partwise
