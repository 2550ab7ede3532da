#pragma once

#include <vector>

#include "remeshing/compatible_mesh.h"

namespace partwise::report {

/// Distance of the middle of each facet of `facets` (indices) of the compatible mesh to the target, over the
/// target's diagonal: its vertices lie on the target, its facets cut curved places short.
std::vector<float> distances_to_target(const CompatibleMesh& mesh, const std::vector<int>& facets);

/// Distance of each of these vertices of the target to the compatible mesh, over the target's diagonal: large
/// where the compatible mesh misses details.
std::vector<float> distances_to_compatible(const CompatibleMesh& mesh, const std::vector<int>& vertices);

/// Per facet of `facets`, source to compatible mesh, the source scaled to the same total area.
struct FacetDistortion {
  std::vector<float> dirichlet;  ///< s1^2 + s2^2 + 1/s1^2 + 1/s2^2; 4 for an isometry
  std::vector<float> area;       ///< log2 of the change of area: 1 is twice as large
};
FacetDistortion facet_distortion(const CompatibleMesh& mesh, const std::vector<int>& facets);

/// The value that `share` of the values do not exceed; 0 when there are none.
double quantile(std::vector<float> values, double share);

}  // namespace partwise::report
