#pragma once

#include <vector>

#include "remeshing/compatible_mesh.h"

namespace partwise {

/// Edges of a compatible mesh's source that can be cut, per half-edge pair of `mesh.source` (OpenMesh's edge
/// index). Those at the boundary, on the boundary of a chart and around facets with added vertices stay
/// whole: the boundaries of source and target are matched vertex by vertex there.
std::vector<bool> splittable_edges(const CompatibleMesh& mesh);

/// Adds vertices to the source, one on each of the edges given ([Wu11] has no such step).
///
/// The source's surface stays as it is; its vertices keep their numbers, new ones follow in the order given.
/// With charts a new vertex goes where the map takes its point of the edge: the images of the old edges stay,
/// and a map that is one-to-one stays so. Without, it goes to the point of the target nearest to the edge's,
/// on the sheet of its ends. Markers, labels and `refinement` follow; `inverse` is empty afterwards, to be
/// made anew (inverse_map) once the vertices are in place. \throws InputError naming a point on an edge that
/// cannot be split
CompatibleMesh split_source(const CompatibleMesh& mesh, const std::vector<EdgePoint>& places);

/// The facets and the first vertices of a source before any vertex was added.
TriMesh original_source(const CompatibleMesh& mesh);

}  // namespace partwise
