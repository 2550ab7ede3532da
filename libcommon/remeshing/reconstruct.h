#pragma once

#include "mapping/domains.h"
#include "remeshing/one_to_one_map.h"

namespace partwise {

/// How a vertex in the common domain finds its place on the target.
enum class Coordinates {
  facet,        ///< by the facet of Q^t_k that contains it
  convex_hull,  ///< by averaging over the target's vertices near it in the domain
  mean_value    ///< the same through mean-value coordinates with respect to the target part's hull
};

struct ReconstructOptions {
  Coordinates coordinates = Coordinates::facet;
  /// Reach of the averaging over the mean edge length of Q^t_k; > 0.
  double radius = 1.5;
  bool one_to_one = true;  ///< move vertices until the whole map is one-to-one, see one_to_one_map.h
};

/// What `reconstruct` met on its way.
struct ReconstructMetrics {
  int ambiguous = 0;  ///< vertices behind which lie several facets of a folded map
  int on_caps = 0;    ///< vertices in the cap of an opening, moved to the opening's boundary
  /// Largest distance from a boundary vertex's place to where the parts' own maps put it, over the target's
  /// diagonal: 0 (within rounding) when the map is continuous across parts.
  double boundary_gap_max = 0;
  double largest_projection = 0;  ///< averaging only: from average to surface, over the target's diagonal
  std::vector<ChartFigures>
      charts;               ///< on which the whole map was unfolded; empty when that was not asked for
  int moved_vertices = 0;   ///< by that
  bool curves_held = true;  ///< false: source vertices left the curves between parts for it
  std::vector<std::string> placed_markers;  ///< released on the hulls, brought to their places by it
};

struct Reconstruction {
  CompatibleMesh mesh;
  ReconstructMetrics metrics;
};

/// Gives every source vertex its place on the target ([Wu11] 5.3).
///
/// With `facet` coordinates a vertex inside a part is located in the image of the target's part, seen from
/// the hull's centre, and keeps its barycentric coordinates there: it lies exactly on the target. Where the
/// target's map is folded, a positively oriented facet is taken, the one nearest to the places of the
/// vertex's neighbours. Vertices on boundary curves sit where CrossMap::boundary says.
///
/// The other modes are the paper's: coordinates with respect to the hull, of the target's vertices near the
/// place in the domain, averaged with weights that fall linearly to 0 at `radius` and applied to the hull.
/// As such coordinates reproduce the points they belong to, this is the weighted average of the target's
/// vertices, and `convex_hull` and `mean_value` agree up to rounding. Differs from [Wu11]: the average is
/// then projected to the target, on the sheet where the facet's place is, because the result is a map.
///
/// Then the joined map is made one-to-one over the seams of the parts (make_one_to_one); the mesh has charts
/// when that succeeded.
/// \throws InputError when the boundary placements do not fit the target
Reconstruction reconstruct(const CrossMap& map, const ReconstructOptions& options = {});

}  // namespace partwise
