#pragma once

#include <string>
#include <vector>

#include "mesh/segmentation.h"

namespace partwise {

/// What keeps the parts of two models from corresponding, one sentence per difference; empty when compatible.
///
/// Compared by names: parts, which parts meet and along how many curves, boundary loops and genus of each
/// part, the parts around cross points (with their cyclic order), anchors and the parts they lie between,
/// markers. Two models of one part each correspond whatever the part is called.
/// Not compared: whether names mean the same place, and in which part a marker lies (see misplaced_markers).
std::vector<std::string> compare_segmentations(const SegmentedModel& a, const SegmentedModel& b);

/// One sentence per marker that lies in other parts on `b` than on `a`: it cannot be held in place.
std::vector<std::string> misplaced_markers(const SegmentedModel& a, const SegmentedModel& b);

}  // namespace partwise
