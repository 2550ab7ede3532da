#pragma once

#include "energy/energy_term.h"
#include "geometry/surface_index.h"

namespace partwise {

/// Where a vertex's normal meets the hull.
struct HullApproach {
  int vertex = 0;
  Vec3 target = Vec3::Zero();  ///< c_i of [Wu11] Eq. (11)
  double distance = 0;         ///< d_i of [Wu11] Eq. (10), in the units of the model
};

/// Casts a ray from every vertex in `vertices` along its normal to the hull, reversed where that meets
/// nothing
/// ([Wu11] 5.1). Vertices whose normal is more than 90 degrees off that of the facet hit, or zero, are left
/// out. \pre normals are unit or zero, one per point
std::vector<HullApproach> approach_hull(const std::vector<int>& vertices, const Points& points,
                                        const Points& normals, const SurfaceIndex& hull,
                                        const Points& hull_facet_normals);

/// E_c = sum of m_i |v_i - c_i|^2 with m_i = 1 / (d_i + 0.01) * A(1-ring of i) / mean 1-ring area
/// ([Wu11] Eq. (10-11)): vertices near the hull and vertices with large facets are drawn onto it first.
///
/// d_i counts in units of `diagonal`, the part's: the paper leaves its unit open, so a model's size would
/// change the result. `ring_areas` has one entry per vertex of the part.
EnergyTerm convex_approximation_term(const std::vector<HullApproach>& approaches,
                                     const std::vector<double>& ring_areas, double diagonal);

}  // namespace partwise
