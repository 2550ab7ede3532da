#pragma once

#include "mapping/star_hull.h"
#include "mesh/tri_mesh.h"

namespace partwise {

struct UntangledMap {
  Points images;         ///< per vertex, on the hull, relative to its centre
  int folds_before = 0;  ///< facets not positively oriented, seen from the centre
  int folds_after = 0;
};

/// Undoes the folds of a map onto a hull as far as it can: the vertices around folded facets are moved over
/// the hull, one at a time, down the regularised energy of Garanzha et al. 2021; the rest and the fixed
/// vertices stay.
///
/// \pre the arguments are those of relax_on_hull, but `start` may have folds
UntangledMap untangle_on_hull(const TriMesh& mesh, const StarHull& hull, const Points& start,
                              const std::vector<bool>& fixed);

}  // namespace partwise
