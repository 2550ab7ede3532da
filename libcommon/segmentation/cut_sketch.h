#pragma once

#include <string>
#include <vector>

#include "segmentation/segment_mesh.h"

namespace partwise {

/// A sketch with the proposed cuts in it, and what it gives.
struct CutSketch {
  Sketch sketch;
  double largest_concavity = 0;           ///< of its parts, as measured after segmenting with it
  std::vector<std::string> lost_anchors;  ///< names: between parts that share no boundary any more
};

/// Adds the pieces' strokes of `segmented.cuts` to the sketch that was segmented, and segments with it.
///
/// Strokes that a part had are shared out among its pieces; anchors go to the piece whose boundary with the
/// other part is nearest; markers stay. The sketch says which mesh it is for.
/// \pre segmented comes from segment_mesh() for this sketch, without split_edges
/// \throws as segment_mesh, when the proposals, each fitting its part, do not fit together
CutSketch with_cuts(const Sketch& sketch, const SegmentedMesh& segmented, SegmentationOptions options);

}  // namespace partwise
