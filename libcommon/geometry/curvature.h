#pragma once

#include "mesh/tri_mesh.h"

namespace partwise {

/// Per vertex: 2 pi minus the angles around it (pi at a boundary vertex), in radians.
///
/// The sum over a closed mesh is 2 pi times its Euler characteristic (Gauss-Bonnet). Facets without area add
/// angles of a degenerate triangle: 0, 0 and pi, or 0 where two corners coincide.
std::vector<double> angle_defects(const TriMesh& mesh);

/// Per vertex: Voronoi area within its 1-ring, with the shares of Meyer et al. 2003 in obtuse facets. The
/// areas sum to that of the mesh. In squared units of the model.
std::vector<double> mixed_areas(const TriMesh& mesh);

/// Per vertex: discrete Gaussian curvature, angle defect over mixed area ([Wu11] Eq. (16)), per squared unit
/// of the model; 0 where the 1-ring has no area.
std::vector<double> gaussian_curvature(const TriMesh& mesh);

}  // namespace partwise
