#pragma once

#include "energy/energy_term.h"
#include "geometry/mean_value_weights.h"
#include "geometry/surface_index.h"
#include "mapping/map_by_energy.h"

namespace partwise {

/// The hull as the energy sees it.
struct HullTarget {
  SurfaceIndex index;
  Points normals;  ///< per facet of the hull, unit

  explicit HullTarget(const ConvexHull& hull);
};

/// Weights of the undeformed mesh for Eq. (7): those of Eq. (8-9), or of Eq. (6).
VertexWeights laplacian_weights(const TriMesh& mesh, LaplacianKind kind);

/// Minimises E_l + w_g E_g + w_c E_c + E_b over the positions of `mesh`'s vertices ([Wu11] Eq. (7-14)): first
/// with w_c = 0, then with growing w_c, normals and their hits with the hull found anew at each step.
///
/// `global` are the constraints of Eq. (12), `boundary` those of Eq. (14); the other vertices are drawn to
/// the hull along their normals. The result lies near the hull, not on it. \throws ComputationError when the
/// constraints leave a component of the mesh free
Points minimise_energy(const TriMesh& mesh, const VertexWeights& weights, const HullTarget& hull,
                       const std::vector<VertexTarget>& global, const std::vector<VertexTarget>& boundary,
                       const EnergyMapOptions& options);

}  // namespace partwise
