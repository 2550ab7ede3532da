#pragma once

#include <vector>

#include "mesh/surface_point.h"

namespace partwise {

/// Facets of a mesh, given by the map of its vertices onto a target, that face against the target.
///
/// The target's normal at a facet is the mean of its normals at the images of the facet's three vertices; at
/// an image it is interpolated between the vertex normals of the target facet that holds it. A facet whose
/// normal makes more than a right angle with that normal is flipped. The images, not closest points, say
/// where the facet belongs: between lips or fingers the closest surface is often another one. Facets without
/// area and facets where the target's normals cancel (a facet around a tip) are not counted. \pre `points`
/// are the positions of the map's source; facets name them \return ascending facet indices
std::vector<int> flipped_facets(const Points& points, const Facets& facets, const SurfaceMap& map,
                                const TriMesh& target);

}  // namespace partwise
