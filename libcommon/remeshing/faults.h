#pragma once

#include <vector>

#include "remeshing/intersection_guard.h"
#include "remeshing/mesh_on_surface.h"

namespace partwise {

/// Counts what is wrong with a compatible mesh near vertices that move: its flipped facets, and its pairs of
/// intersecting ones.
class FaultCounter {
 public:
  /// `mesh` outlives the counter, which has to hear of every move (moved).
  explicit FaultCounter(const MeshOnSurface& mesh) : mesh_(mesh), guard_(mesh) {}

  /// Faults of the facets beside `vertex`, where it is now.
  int around(int vertex) const;

  /// Faults of some facets. \pre ascending
  int of(const std::vector<int>& facets) const;

  /// Notes that `vertex` has moved.
  void moved(int vertex) { guard_.moved(vertex); }

 private:
  const MeshOnSurface& mesh_;
  IntersectionGuard guard_;
};

/// Moves corners of flipped and of intersecting facets, one after another, to where the facets around them
/// have the fewest faults: the mean of their neighbours, places towards each neighbour, half ways. A sweep
/// goes over all such corners; at most `sweeps` are made. No step adds a flipped facet; pinned vertices stay,
/// and a map that is one-to-one stays so. How far the mesh is from the target is not looked at. \return moves
/// made
int mend_faults(MeshOnSurface& mesh, int sweeps);

}  // namespace partwise
