#pragma once

#include <vector>

#include "segmentation/patch_graph.h"

namespace partwise {

/// Where a part could be cut into less concave pieces: looked for coarsely, see cut_proposals.h for what is
/// made of it.
///
/// What sticks out is cut off one after the other: for every end of the shape the neck, where the boundary is
/// shortest for the area beyond it, and the cut through the deepest place of the whole; of all these the one
/// that takes most of the area-weighted depth below the hull for its length. Ends when no piece is deeper
/// than `goal`, or nothing is gained; cuts that the goal does not need are taken back.
/// \param goal depth below the hull, in units of the model
/// \param most how many pieces may be cut off
/// \return per patch: 0 for what is left over, 1, 2, ... for the pieces cut off; all 0 when nothing is gained
std::vector<int> search_cuts(const PatchGraph& graph, double goal, int most);

/// Depth of the deepest of some patches below their hull, in units of the model; 0 for flat ones.
double largest_depth(const PatchGraph& graph, const std::vector<int>& patches);

}  // namespace partwise
