#pragma once

#include "mapping/map_by_energy.h"
#include "remeshing/compatible_mesh.h"
#include "remeshing/critical_fit.h"

namespace partwise {

struct UmbrellaOptions {
  int rounds = 4;             ///< of Eq. (18); >= 0
  double lambda = 0.5;        ///< > 0, in mean edge lengths
  double convergence = 1e-4;  ///< rounds end when the mean move falls below this, over the diagonal
  LaplacianKind weights = LaplacianKind::mean_value;  ///< or uniform, for comparison
  CriticalFitOptions critical = {};
};

/// What came of the paper's scheme.
struct UmbrellaResult {
  std::vector<SurfacePoint> images;  ///< per source vertex, on the target
  int rounds = 0;
  int critical_reached = 0;  ///< vertices that sit at a critical point in the end
};

/// The paper's own remeshing, for comparison: vertices leave the target and are projected back ([Wu11] 6.1.2
/// and 6.2, Fig. 11 d and e; without critical points Fig. 11 c).
///
/// 1. Every critical point draws the closest vertex: |L V - L V_0|^2 + weight sum |v_i - s_i|^2, Eq. (17), a
/// few
///    times over, L the source's mean-value Laplacian.
/// 2. Rounds of v_i <- v_i + (lambda / d) U, U = sum_j w_ij (v_j - v_i), Eq. (18), all vertices at once; d is
/// the
///    distance to the target along U. At most the whole of U, since the paper divides by 0 on the target; d
///    counts in mean edge lengths, as the paper leaves its unit open.
/// 3. Projection along the last U (both ways, the nearer hit), to the closest point where that meets nothing
/// within
///    a mean edge length.
///
/// Markers at vertices, the boundary of an open source and vertices at critical points stay. Nothing keeps
/// facets from folding or the map from losing its certificate: `relocate`'s own method exists for that.
UmbrellaResult relocate_by_umbrella(const CompatibleMesh& mesh, const UmbrellaOptions& options);

}  // namespace partwise
