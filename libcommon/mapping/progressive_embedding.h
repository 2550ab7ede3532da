#pragma once

#include "mesh/tri_mesh.h"

namespace partwise {

/// One-to-one map of a closed genus-0 mesh onto the unit sphere, by progressive embedding in the mesh's own
/// metric (after Praun and Hoppe 2003): the mesh is collapsed to a tetrahedron, the vertices are put back one
/// by one, each where all facets around it stay positively oriented seen from the centre, and positions are
/// relaxed on the way.
///
/// `vertex_weights` (one per vertex, > 0) says how much distortion counts: a facet has the smallest weight of
/// its vertices. The vertices at the centres of caps want a small one. Returns unit directions, one per
/// vertex: every facet has det(p1, p2, p3) > 0 by floating-point evaluation in the difference form, and the
/// sphere is covered once. \pre the mesh is closed, connected, of genus 0 \throws InputError when it is not;
/// ComputationError naming the vertex when no place is found for it (below the
///         resolution of double precision).
Points embed_progressively(const TriMesh& mesh, const std::vector<double>& vertex_weights);

}  // namespace partwise
