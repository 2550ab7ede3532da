#pragma once

#include <vector>

#include "mesh/segmentation.h"
#include "segmentation/random_walker.h"
#include "segmentation/segment_mesh.h"

namespace partwise {

struct TransferOptions {
  bool align_boxes = false;   ///< first bring the segmented mesh's bounding box onto the other's
  SegmentationOptions usual;  ///< `snap_limit` also bounds how far the meshes may lie apart
};

/// Whose parts every facet lies on, seen from another mesh.
struct LabelShares {
  PartProbabilities shares;     ///< row f: per part, the share of facet f's area closest to it
  double mean_distance = 0;     ///< area-weighted, from `mesh` to the labelled mesh, units of the model
  double largest_distance = 0;  ///< of all samples, units of the model
  int farthest_facet = 0;       ///< of `mesh`
};

/// Samples the facets of `mesh` evenly, the larger the denser, and looks up the closest facet of a labelled
/// mesh in the same place. \pre labels has one entry per facet of `labelled`, 0 <= label < part_count
LabelShares closest_labels(const TriMesh& mesh, const TriMesh& labelled, const std::vector<int>& labels,
                           int part_count);

/// A segmentation that came from another mesh, and how faithfully.
struct TransferredSegmentation {
  SegmentedMesh segmented;
  bool copied = false;          ///< equal connectivity: labels, markers and anchors are the same indices
  double moved_area = 0;        ///< share of the area whose part is not that of the closest facet
  double mean_distance = 0;     ///< between the meshes, over the diagonal; 0 when copied
  double largest_distance = 0;  ///< likewise
};

/// Takes over the parts, markers and anchors of a model that shows the same shape.
///
/// With equal connectivity (all poses of one mesh) they are copied. Otherwise every facet takes the part of
/// the closest facets; facets that straddle a boundary take the part that makes it short (see cut_band), then
/// labels are repaired (see repair_labels). Markers go to the closest surface points, anchors to the nearest
/// curve vertices; proposed anchors are not taken over. Meshes are compared where they are, except under
/// `align_boxes`; closeness is in space, so where two sheets nearly touch, islands of the wrong part may have
/// to be repaired. \param additions its markers and anchors are added, and replace those of equal name; its
/// strokes say
///        nothing here
/// \throws InputError when the meshes do not lie on each other, a part gets no facet, `additions` names a
///         part that there is not, or a landmark has no place; ComputationError as segment_mesh
TransferredSegmentation transfer_labels(const TriMesh& mesh, const SegmentedModel& from,
                                        const Sketch& additions, const TransferOptions& options);

}  // namespace partwise
