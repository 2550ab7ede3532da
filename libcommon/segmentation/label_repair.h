#pragma once

#include <string>
#include <vector>

#include "segmentation/seeds.h"

namespace partwise {

/// A labelling in which every part is connected and nowhere pinched, and what it took to get there.
struct RepairedLabels {
  std::vector<int> labels;  ///< per facet
  int merged_islands = 0;   ///< surplus components given to a neighbour
  int removed_pinches = 0;  ///< extra fans removed
  int changed_facets = 0;
};

/// Makes a labelling valid: boundaries become simple curves of edges.
///
/// Per part the component with the largest seeded area stays (of equal ones the larger), the others go to
/// the neighbour they share the costliest boundary with. Then, while a part has more than one fan at a
/// vertex: the cheapest relabelling of a fan, the ring, or a ball of 2-4 rings around it that lowers the
/// number of extra fans and cuts no part in two (crumbs cut off go along).
/// \param boundary_costs per edge, see crease_field.h
/// \throws InputError when a part ends without facets; ComputationError naming the vertex when a pinch cannot
///         be removed.
RepairedLabels repair_labels(const TriMesh& mesh, const std::vector<std::string>& names, const Seeds& seeds,
                             std::vector<int> labels, const std::vector<double>& boundary_costs);

}  // namespace partwise
