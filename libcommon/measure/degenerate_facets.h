#pragma once

#include <vector>

#include "mesh/types.h"

namespace partwise {

/// When a facet counts as having no area; both are free of the model's scale.
struct DegenerateThresholds {
  double area = 1e-8;      ///< over the mean area of the mesh's facets
  double altitude = 1e-6;  ///< smallest altitude over the longest edge
};

/// Facets at or below one of the thresholds: collapsed to a point, or to a needle or cap without
/// width. \return ascending facet indices
std::vector<int> degenerate_facets(const Points& points, const Facets& facets,
                                   const DegenerateThresholds& thresholds = {});

}  // namespace partwise
