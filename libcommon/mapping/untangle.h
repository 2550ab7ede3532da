#pragma once

#include "energy/symmetric_dirichlet.h"
#include "mapping/star_surface.h"
#include "mesh/tri_mesh.h"

namespace partwise {

struct UntangledMap {
  Points images;            ///< per vertex, on the surface
  std::vector<bool> moved;  ///< per vertex: false where the image is the start's, projected on the surface
  int folds_before = 0;     ///< facets not positively oriented, seen from the origin
  int folds_after = 0;
};

/// Undoes the folds of a map onto a star-shaped surface as far as it can, down the regularised energy of
/// Garanzha et al. 2021: the vertices around folded facets move over the surface, first one at a time, then,
/// where folds stay that only many vertices together can undo, all of a region at once by Newton's method.
/// The rest and the fixed vertices stay where `start` has them.
///
/// \param references one per facet, in the surface's size
/// \param start one per vertex, of any length > 0
/// \param fixed empty or one per vertex
UntangledMap untangle(const TriMesh& mesh, const std::vector<ReferenceTriangle>& references,
                      const StarSurface& surface, const Points& start, const std::vector<bool>& fixed);

}  // namespace partwise
