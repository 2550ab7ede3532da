#pragma once

#include <vector>

#include "segmentation/seeds.h"

namespace partwise {

/// Grows the seeds over the whole mesh by vertices, cheapest step first ([Wu11] Eq. (1-3)); a label per
/// facet.
///
/// Stepping from s to its neighbour t with e = t - s costs f = (1 + n_s . e / |e|)(1 + |n_s x n_t|), so
/// regions spread easily over convex and flat places and hesitate at concave ones. Of the vertices known so
/// far, the cheapest step decides, not the sum of steps. A facet takes the largest part index of its
/// vertices, which leaves straighter boundaries than the majority. Equal costs are decided by part, then
/// vertex index. \pre every component of the mesh has a seed vertex
std::vector<int> grow_regions(const TriMesh& mesh, const Seeds& seeds);

}  // namespace partwise
