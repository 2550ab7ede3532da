#pragma once

#include "remeshing/mesh_on_surface.h"

namespace partwise {

struct CoverageFitOptions {
  int rounds = 3;
  double threshold = 0.0008;   ///< target vertices farther away than this times the target's diagonal pull
  double least_quality = 0.3;  ///< no facet gets worse than this by a move; see MeshOnSurface
  /// The same for what is missed by far after these rounds, as the tip of a horn that slipped through a
  /// facet.
  int far_rounds = 8;
  double far_threshold = 0.002;
  double far_least_quality = 0.05;
};

/// Draws vertices of the compatible mesh onto details of the target that it misses.
///
/// A target vertex far from the compatible mesh pulls a corner of the nearest facet, the nearest one that can
/// reach it over the target. The corner moves there (else half way) if no facet gets too flat, no further
/// pair of facets intersects, and the sum of squared distances from all target vertices that were nearest to
/// the facets around it falls. Then those farther than `far_threshold` may pull facets flatter. Returns the
/// moves made.
int fit_coverage(MeshOnSurface& mesh, const CoverageFitOptions& options = {});

}  // namespace partwise
