#pragma once

#include "mesh/tri_mesh.h"

namespace partwise {

/// One-to-one map of a closed genus-0 mesh onto the unit sphere that exists for every such mesh: without
/// `removed` and its facets the mesh is a disc, which is laid out with its rim on a circle and every other
/// vertex at the mean of its neighbours (Tutte 1963), then lifted gnomonically: (x, y) goes to the direction
/// (2x, 2y, 1), `removed` to (0, 0, -1). Lines become great circles, so that no facet turns over.
///
/// Far vertices crowd in the middle, more than double precision can tell apart on large meshes with small
/// rims; a relaxation must follow. Returns unit directions, every facet with det(p1, p2, p3) > 0 by
/// floating-point evaluation in the difference form. \pre the mesh is closed, connected, of genus 0
/// \throws ComputationError naming the facet that double precision could not place
Points embed_by_lifting(const TriMesh& mesh, int removed);

}  // namespace partwise
