#pragma once

#include <vector>

#include "mapping/domains.h"

namespace partwise {

/// Per marker: distance between the source's marker carried to the compatible mesh (facet and barycentric
/// coordinates stay, the facet's vertices move to `points`) and the target's marker, in the target's units.
/// \pre facets and barycentric coordinates of the markers fit the meshes
std::vector<double> marker_errors(const std::vector<MarkerPair>& markers, const Facets& source_facets,
                                  const Points& points, const TriMesh& target);

}  // namespace partwise
