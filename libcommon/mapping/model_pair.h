#pragma once

#include <string>
#include <vector>

#include "mapping/domains.h"

namespace partwise {

/// A named vertex on a boundary curve of both models; a marker that is one on both serves as an anchor.
struct AnchorPair {
  std::string name;
  int source_vertex = 0;
  int target_vertex = 0;
  bool from_marker = false;
};

/// A marker that lies in the same part on both models, both points given in facets of that part.
struct MarkerConstraint {
  int pair = 0;  ///< index into ModelPair::markers
  int part = 0;  ///< in the target's order
  SurfacePoint source;
  SurfacePoint target;
};

/// What two models have in common by their names. Refers to the models: they must outlive it.
struct ModelPair {
  const SegmentedModel& source;
  const SegmentedModel& target;
  std::vector<int> source_part;  ///< per part of the target: the source's part of that name
  std::vector<int> target_part;  ///< per part of the source: the target's
  std::vector<AnchorPair> anchors;
  std::vector<MarkerPair> markers;
  std::vector<MarkerConstraint> marker_constraints;
  std::vector<std::string> warnings;  ///< landmarks that cannot be used, one sentence each

  /// Part of the source in the target's numbering; kOutside stays kOutside.
  int in_target(int part_of_source) const;
};

/// Pairs parts, anchors and markers by name.
///
/// Markers and anchors named on one model only, and markers that lie in different parts, are reported in
/// `warnings`; a marker on a part boundary belongs to all parts around it. Proposed anchors are left out.
/// \throws InputError naming the parts that only one model has.
ModelPair pair_models(const SegmentedModel& source, const SegmentedModel& target);

/// The similarity from the source's space to the target's by centroids of parts, anchors and markers; what
/// these leave open is taken as unrotated and as scaled by the models' diagonals.
Eigen::Affine3d align_models(const ModelPair& pair);

/// As align_models, but what lies in or on the parts named (in the target's order) counts for more.
Eigen::Affine3d align_around(const ModelPair& pair, const std::vector<int>& parts,
                             const Eigen::Affine3d& prior);

}  // namespace partwise
