#pragma once

#include "io/document.h"
#include "segmentation/segment_mesh.h"

namespace partwise::io {

/// What the segmentation measured of itself: the metrics of the tool `segment`.
Json segment_metrics(const SegmentedMesh& segmented);

/// The member `proposed_cuts` of a segment document: see schemas/README.md.
Json cut_facts(const SegmentedMesh& segmented);

}  // namespace partwise::io
