#pragma once

#include <vector>

#include "mesh/segmentation.h"

namespace partwise {

/// Places where an anchor would help: two on every closed curve between two parts that has fewer than two.
///
/// Where the user anchored the curve's mirror image ("left arm" for "right arm"), those anchors mirrored, see
/// mirrored_anchors(). Else the first lies nearest to a marker that is near the curve (within 0.15 of its
/// length), or else where the curve reaches farthest towards the centroid of another part, the one whose
/// direction lies most within the curve's plane; the second where the curve reaches farthest the other way.
/// Names say which
/// ("body-tail towards head (proposed)"), so proposals of two models that chose differently do not
/// meet. Parts that share several closed curves get none: names could not tell them apart.
/// They are for a person to look at and copy into a sketch; stages that pair models leave them out. For as
/// anchors they lose against the best shift (see loop_shift.h): over all 32 ordered pairs of six animals and
/// of two humans, true anchors lay 0.038 of a curve's length from their counterparts by the best shift alone
/// and 0.040 with proposals; without markers 0.039 and 0.045.
/// \pre markers and anchors lie on `mesh`, `segmentation` is valid
std::vector<Anchor> propose_anchors(const TriMesh& mesh, const Segmentation& segmentation,
                                    const std::vector<Marker>& markers, const std::vector<Anchor>& anchors);

}  // namespace partwise
