#pragma once

#include "geometry/facet_grid.h"
#include "remeshing/mesh_on_surface.h"

namespace partwise {

/// Counts the facets that others run into around a vertex that moves over the target, so that a step that
/// makes the mesh intersect itself can be taken back.
class IntersectionGuard {
 public:
  /// `mesh` outlives the guard, which has to hear of every move (moved).
  explicit IntersectionGuard(const MeshOnSurface& mesh);

  /// Pairs of intersecting facets of which at least one is beside `vertex`, where it is now.
  int count_around(int vertex) const;

  /// The same for some facets. \pre ascending
  int count_of(const std::vector<int>& facets) const;

  /// Notes that `vertex` has moved.
  void moved(int vertex);

 private:
  const MeshOnSurface& mesh_;
  FacetGrid grid_;
};

}  // namespace partwise
