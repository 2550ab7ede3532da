#pragma once

#include "mapping/domains.h"

namespace partwise {

enum class LaplacianKind { mean_value, uniform };

/// Where on the hull a vertex is drawn: where its normal meets it ([Wu11] Eq. (10-11), Fig. 9d), or, for
/// comparison, to its closest point, as iterative closest point schemes do (Fig. 9c).
enum class HullFitting { normal, closest_point };

/// Every weight of the paper's energy, [Wu11] Eq. (13).
struct EnergyMapOptions {
  LaplacianKind laplacian = LaplacianKind::mean_value;  ///< Eq. (8-9), or Eq. (6) for comparison
  HullFitting fitting = HullFitting::normal;
  double global_weight = 0.3;          ///< w_g
  double first_convex_weight = 0.001;  ///< w_c of the first step after the initial one
  double last_convex_weight = 0.01;    ///< w_c of the last step
  int steps = 10;                      ///< how many, w_c growing evenly; 0 leaves w_c at 0
};

/// A part brought onto its own hull by the paper's energy, and what had to be done to it afterwards.
struct EnergyMap {
  Points images;         ///< per local vertex of the part, on the hull, in the model's coordinates
  double off_hull = 0;   ///< largest distance to the hull before the projection, in units of the model
  int folds_before = 0;  ///< folded facets after the projection, seen from the hull's centre
  int folds_after = 0;   ///< after their repair
};

/// Deforms a capped part into its convex hull ([Wu11] 5.1): minimises E_l + w_g E_g + w_c E_c, Eq. (13),
/// first with w_c = 0, then with growing w_c, normals and their hits with the hull found anew at each step.
///
/// G of Eq. (12) are the hull's vertices and the concave extreme points, as in the paper, and the vertices on
/// the part's boundary loops, drawn to the point of the hull closest to them: the rim of the piece of hull
/// that covers the opening. Centres of caps move freely.
///
/// Differs from [Wu11]: the energy ends neither on the hull nor without folds, so the result is projected
/// centrally onto the hull (from its centre all of it is visible) and folds are repaired locally as far as
/// that succeeds. Not guaranteed: that none remain, or that the hull is covered only once.
EnergyMap map_by_energy(const Part& part, const ConvexHull& hull, const EnergyMapOptions& options);

}  // namespace partwise
