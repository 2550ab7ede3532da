#pragma once

#include "remeshing/mesh_on_surface.h"

namespace partwise {

struct UnfoldOptions {
  int sweeps = 40;
  int rings = 2;  ///< how far around a flipped facet vertices move, one more after every 20 sweeps
};

/// Turns flipped facets over by moving the vertices around them, each in the target's tangent plane, down the
/// regularised energy of FoldoverFree against the source's facets (scaled to the size of the vertex's ring,
/// so that shape counts, not size). Vertex by vertex, a Newton step each; a step is taken if it lowers the
/// energy and flips no facet. Returns the number of facets that remain flipped.
int unfold(MeshOnSurface& mesh, const UnfoldOptions& options = {});

/// Lowers the same energy everywhere, for `sweeps` sweeps: evens out the map's distortion, sizes included.
/// `scales` says per source facet how much longer its edges should be on the target; empty leaves sizes out,
/// as in `unfold`.
void relax(MeshOnSurface& mesh, int sweeps, const std::vector<double>& scales);

}  // namespace partwise
