#pragma once

#include <functional>

#include "mapping/pin_on_hull.h"

namespace partwise {

/// A map with those markers in place that leave no folds, or fewest.
struct MarkedMap {
  PinnedMap map;
  std::vector<bool> held;  ///< per marker: false when it was only drawn towards its goal
};

/// Maps with `held` exactly at their goals and `drawn` near theirs.
using MapWithMarkers = std::function<PinnedMap(const std::vector<Pin>& held, const std::vector<Pin>& drawn)>;

/// Holds all markers if that leaves no folds. Otherwise releases them one by one, each time the one without
/// which the fewest folds remain, of equal ones the one that stays nearest to its goal, until none remain; at
/// last those that turn out to have been innocent are held again. Keeps them all when releasing does not
/// help. \param folds counts the folds that count
MarkedMap map_with_markers(const std::vector<Pin>& markers, const MapWithMarkers& map_with,
                           const std::function<int(const PinnedMap&)>& folds);

}  // namespace partwise
