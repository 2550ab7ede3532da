#pragma once

#include <vector>

#include "segmentation/band_cut.h"

namespace partwise {

struct RefinementOptions {
  double width = 0.03;  ///< how far a round may move a boundary, over the diagonal
  int rounds = 4;       ///< at most; fewer when a round changes nothing
  BandCutOptions band_cut;
};

/// Straightens the boundaries of given labels: each round cuts them anew in a narrow band around where they
/// are, short and along creases, as an active contour moves ([Wu11] 4.2, after Ji et al. 2006, "Easy mesh
/// cutting").
///
/// A facet at the distance d from another part (over the surface, from centroid to centroid) counts as that
/// part's with the odds exp(-1.2 d / (width l)) to 1, and cut_band decides. Differs from [Wu11]: a minimum
/// cut in the band instead of a snake's gradient descent, because it handles several parts and their cross
/// points at once and does not stop in the first minimum.
///
/// \param labels per facet \param boundary_costs per edge, see crease_field.h
std::vector<int> refine_boundaries(const TriMesh& mesh, const Seeds& seeds, int part_count,
                                   std::vector<int> labels, const std::vector<double>& boundary_costs,
                                   const RefinementOptions& options);

}  // namespace partwise
