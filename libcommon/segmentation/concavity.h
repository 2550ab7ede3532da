#pragma once

#include <vector>

#include "mesh/segmentation.h"

namespace partwise {

/// Per part: how far its vertices are from its convex hull, over the mesh's diagonal ([Wu11] 4.2). A flat
/// part counts as convex.
/// \param labels per facet, the part it belongs to; \pre 0 <= label < part_count for as many as there are
/// facets
std::vector<Concavity> measure_concavity(const TriMesh& mesh, const std::vector<int>& labels, int part_count);

}  // namespace partwise
