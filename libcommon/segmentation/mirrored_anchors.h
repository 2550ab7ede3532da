#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mesh/segmentation.h"

namespace partwise {

/// The name with its word "left" made "right" or the other way round ("left arm", "arm-Right"); none without.
std::optional<std::string> mirrored_name(const std::string& name);

/// The anchors of a curve's mirror image, carried over to the curve: for limbs that come in pairs.
///
/// Parts are paired by their names' "left" and "right"; the mirror's direction is the mean of those from the
/// right to the left parts' centroids. An anchor on the curve between the mirrored parts goes to the vertex
/// nearest to its place, relative to the curves' centroids, once mirrored. Called as the anchor, left and
/// right exchanged, with " (proposed)"; none where the model has such an anchor, or where the mirrored place
/// is farther than 0.15 of the curve's length from the curve.
/// \pre curve is one of the segmentation's, closed, with a part on either side; no other curve joins the two
std::vector<Anchor> mirrored_anchors(const TriMesh& mesh, const Segmentation& segmentation,
                                     const BoundaryCurve& curve, const std::vector<Anchor>& anchors,
                                     const Points& part_centroids);

}  // namespace partwise
