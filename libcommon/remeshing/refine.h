#pragma once

#include "remeshing/compatible_mesh.h"
#include "remeshing/coverage_fit.h"
#include "remeshing/gap_closing.h"
#include "remeshing/unfold.h"

namespace partwise {

struct RefineOptions {
  /// Two-sided distance to get below, over the target's diagonal; 0: add nothing.
  double error = 0;
  double limit = 0.2;  ///< added vertices at most, as a share of the source's own
  // After each round, in this order:
  GapClosingOptions gaps = {.rounds = 1};  ///< with half of `error` as threshold where that is less
  CoverageFitOptions fit = {.rounds = 1, .far_rounds = 0};
  UnfoldOptions unfold = {};
  int mend_sweeps = 3;  ///< of mend_faults; >= 0
};

/// What refine found and did.
struct RefineFigures {
  int added_vertices = 0;
  int rounds = 0;
  int gaps_before = 0, gaps_after = 0;  ///< places with a distance above the one wanted, see CoverageGaps
};

struct Refined {
  CompatibleMesh mesh;
  RefineFigures figures;
};

/// Adds vertices to the source of a compatible mesh where it is too coarse for the target, until both
/// surfaces are within `error` of each other wherever surface_distance looks, the limit is reached, or the
/// widest gap has long got no narrower.
///
/// Round by round the facets at the widest gaps (CoverageGaps) are cut (choose_cuts), except where that would
/// fold the map; then the mesh around new vertices closes in on what is missed (close_gaps), vertices are
/// drawn onto what is left of it (fit_coverage), and what that has spoiled is turned over (unfold) and mended
/// (mend_faults). The surface of the source stays the same and its vertices
/// keep their numbers; a map that is one-to-one stays so. \throws InputError when options are out of range
Refined refine(const CompatibleMesh& mesh, const RefineOptions& options);

}  // namespace partwise
