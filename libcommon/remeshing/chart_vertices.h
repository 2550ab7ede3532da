#pragma once

#include "remeshing/chart_source.h"

namespace partwise {

/// Adds the vertices to `mesh` that the source's side of its charts needs:
///
/// - where a boundary of a chart bends on the target, the target's vertex, at the same share of arc length
///   between the two source vertices beside it; so the two boundaries become the same curve;
/// - the middle of every edge inside a chart that joins two of its boundary's vertices (its image still
///   unknown, facet -1): a facet whose corners all are on the boundary could not be unfolded.
///
/// \throws InputError naming the vertex when the boundaries of source and target do not correspond one-to-one
void add_chart_vertices(CompatibleMesh& mesh, const std::vector<ChartTarget>& targets);

}  // namespace partwise
