#pragma once

#include <vector>

#include "geometry/surface_index.h"
#include "segmentation/sketch.h"

namespace partwise {

/// Projects a polyline drawn on the screen onto the mesh ([Wu11] 4.2); vertices in the order of the stroke.
///
/// A ray per sample (at most a pixel apart, closer where neighbouring samples hit distant facets) takes the
/// corner nearest to its first hit, so hidden surface stays untouched. Samples that miss the mesh are passed
/// over. Vertices that no edge joins are bridged by the shortest path along edges, unless they lie on
/// different components. Empty when no sample hits.
/// \pre camera: width, height > 0, projection * view invertible
std::vector<int> project_stroke(const TriMesh& mesh, const SurfaceIndex& index, const ScreenStroke& stroke);

/// Vertices of the shortest path along edges, both ends included; empty when there is none.
std::vector<int> shortest_edge_path(const TriMesh& mesh, int from, int to);

}  // namespace partwise
