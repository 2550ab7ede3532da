#pragma once

#include <set>
#include <utility>
#include <vector>

#include "mesh/split_edges.h"
#include "remeshing/compatible_mesh.h"
#include "remeshing/coverage_gaps.h"

namespace partwise {

/// Source edges to cut, and what for.
struct RefinementCuts {
  std::vector<EdgePoint> places;
  std::vector<SurfacePoint> goals;  ///< per place: where on the target the mesh should come near
};

/// Edges of a source by their vertices, the smaller first.
using EdgeSet = std::set<std::pair<int, int>>;

/// Chooses edges to cut at gaps, the widest first, at most one per facet: the facet's longest edge, or where
/// the facet across has a far longer one, that, and so on; always in the middle. So facets do not get flatter
/// with every cut, as they do when the edge nearest to the gap is taken; flat ones fold over.
///
/// Gaps narrower than half the widest are left. \param gaps as of CoverageGaps \param most how many cuts
/// \param uncuttable edges that are left, besides those that cannot be split (splittable_edges)
RefinementCuts choose_cuts(const CompatibleMesh& mesh, const std::vector<CoverageGap>& gaps, int most,
                           const EdgeSet& uncuttable);

/// Splits the source at the cuts, except those whose new vertex would fold a one-to-one map: the image is
/// rounded, which tells on the tiniest facets. These are moved from `cuts` to `uncuttable`.
CompatibleMesh split_source_one_to_one(const CompatibleMesh& mesh, RefinementCuts& cuts, EdgeSet& uncuttable);

}  // namespace partwise
