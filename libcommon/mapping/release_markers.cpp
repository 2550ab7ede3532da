#include "mapping/release_markers.h"

#include <algorithm>
#include <utility>

namespace partwise {
namespace {

class Release {
 public:
  Release(const std::vector<Pin>& markers, const MapWithMarkers& map_with,
          const std::function<int(const PinnedMap&)>& folds)
      : markers_(markers), map_with_(map_with), folds_(folds) {}

  MarkedMap run() {
    const MarkedMap all = mapped(std::vector<bool>(markers_.size(), true));
    MarkedMap best = all;
    while (folds_(best.map) > 0 && std::count(best.held.begin(), best.held.end(), true) > 0) {
      best = released(best.held);
    }
    if (folds_(best.map) >= folds_(all.map)) return all;
    return folds_(best.map) == 0 ? held_again(std::move(best)) : best;
  }

 private:
  MarkedMap mapped(const std::vector<bool>& held) const {
    std::vector<Pin> fixed, drawn;
    for (std::size_t i = 0; i < markers_.size(); ++i) (held[i] ? fixed : drawn).push_back(markers_[i]);
    return {map_with_(fixed, drawn), held};
  }

  /// Folds, then the largest distance of a released marker to its goal.
  std::pair<int, double> cost(const MarkedMap& marked) const {
    double largest = 0;
    for (std::size_t i = 0; i < markers_.size(); ++i) {
      if (marked.held[i]) continue;
      largest = std::max(largest, (marked.map.images[markers_[i].vertex] - markers_[i].goal).norm());
    }
    return {folds_(marked.map), largest};
  }

  /// The best of the maps with one marker less.
  MarkedMap released(std::vector<bool> held) const {
    MarkedMap best;
    for (std::size_t i = 0; i < held.size(); ++i) {
      if (!held[i]) continue;
      held[i] = false;
      MarkedMap tried = mapped(held);
      held[i] = true;
      if (best.held.empty() || cost(tried) < cost(best)) best = std::move(tried);
    }
    return best;
  }

  MarkedMap held_again(MarkedMap best) const {
    // With fewer released, every way of holding one more has been tried.
    if (std::count(best.held.begin(), best.held.end(), false) < 3) return best;
    for (std::size_t i = 0; i < markers_.size(); ++i) {
      if (best.held[i]) continue;
      std::vector<bool> held = best.held;
      held[i] = true;
      MarkedMap tried = mapped(held);
      if (folds_(tried.map) == 0) best = std::move(tried);
    }
    return best;
  }

  const std::vector<Pin>& markers_;
  const MapWithMarkers& map_with_;
  const std::function<int(const PinnedMap&)>& folds_;
};

}  // namespace

MarkedMap map_with_markers(const std::vector<Pin>& markers, const MapWithMarkers& map_with,
                           const std::function<int(const PinnedMap&)>& folds) {
  return Release(markers, map_with, folds).run();
}

}  // namespace partwise
