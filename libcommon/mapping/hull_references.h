#pragma once

#include <vector>

#include "energy/symmetric_dirichlet.h"
#include "mesh/tri_mesh.h"

namespace partwise {

/// Per facet: what its image on a hull of the given area is measured against, the mesh scaled to that area.
///
/// Facets too flat or too small to be compared with anything (below 2 % of an equilateral one's area for its
/// edges, 1 % of the mean area) count as equilateral: they would stiffen the map without being seen.
std::vector<ReferenceTriangle> hull_references(const TriMesh& mesh, double hull_area);

}  // namespace partwise
