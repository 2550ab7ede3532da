#pragma once

#include "remeshing/compatible_mesh.h"
#include "remeshing/coverage_fit.h"
#include "remeshing/unfold.h"

namespace partwise {

struct RefineOptions {
  /// Two-sided distance to get below, over the target's diagonal; 0: add nothing.
  double error = 0;
  double limit = 0.2;  ///< added vertices at most, as a share of the source's own
  CoverageFitOptions fit = {.rounds = 1, .far_rounds = 0};  ///< after each round
  UnfoldOptions unfold = {};                                ///< after that
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
/// surfaces are within `error` of each other, the limit is reached, or the widest gap gets no narrower.
///
/// Round by round the widest gaps (CoverageGaps) are cut across the edge that is long and near
/// (split_source), and fit_coverage draws the new vertices to what is missed; then unfold turns flipped
/// facets. The surface of the source stays the same and its vertices keep their numbers; a map that is
/// one-to-one stays so. \throws InputError when options are out of range
Refined refine(const CompatibleMesh& mesh, const RefineOptions& options);

}  // namespace partwise
