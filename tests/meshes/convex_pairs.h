#pragma once

#include "mapping/domains.h"

/// Cross maps between models whose parts are star-shaped: central projection takes the place of the hull
/// maps.
namespace partwise::tests {

/// The whole mesh as one part.
SegmentedModel whole(const TriMesh& mesh);

/// The halves below and above z = 0 as two parts. \pre the plane z = 0 holds a curve of edges
SegmentedModel halves(const TriMesh& mesh);

/// Every part projected from its hull's centre to its hull. \pre the parts are star-shaped about it
HullMap projected(const SegmentedModel& model);

/// Both models' parts projected to the target's hulls. Boundary vertices go to the nearest point of the
/// target's boundary curves; markers are passed on.
/// \pre the same parts in the same order
CrossMap projected_pair(const SegmentedModel& source, const SegmentedModel& target,
                        std::vector<MarkerPair> markers = {});

}  // namespace partwise::tests
