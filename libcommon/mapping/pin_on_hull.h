#pragma once

#include "mapping/relax_on_hull.h"

namespace partwise {

/// A map onto a hull with some vertices in given places.
struct PinnedMap {
  Points images;  ///< per vertex, on the hull, relative to its centre; pins exactly at their goals
  int folds = 0;  ///< facets not positively oriented seen from the centre: 0 when the map is one-to-one
  double distortion = 0;  ///< as HullRelaxation
  double pulled_distance =
      0;  ///< largest distance left to a goal before the pins were set, over the hull's diagonal
};

struct PinOptions {
  double pull_growth = 100;  ///< of the pulls' weight from one relaxation to the next; lower is more patient
  int iterations_per_pull = 6;  ///< Newton steps
  std::vector<Pin> drawn;  ///< vertices that come as near to their goals as the pins allow, without folds
};

/// Moves a one-to-one map so that every pin reaches its goal and distortion stays low: pulls of growing
/// weight bring the pins there without turning a facet over, then the pins are set exactly, folds that this
/// makes are undone, and the rest relaxes once more.
///
/// \pre those of relax_on_hull; goals lie on the hull; no vertex is pinned or drawn twice
/// \param kept edges between pins that must stay whole, see split_chords
PinnedMap pin_on_hull(const TriMesh& mesh, const std::vector<double>& vertex_weights, const StarHull& hull,
                      const Points& start, const std::vector<Pin>& pins,
                      const std::vector<std::array<int, 2>>& kept, const PinOptions& options = {});

}  // namespace partwise
