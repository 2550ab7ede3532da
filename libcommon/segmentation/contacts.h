#pragma once

#include <string>
#include <vector>

#include "segmentation/label_repair.h"

namespace partwise {

/// Labels without accidental contacts, and a sentence for each contact that was separated.
struct SeparatedLabels {
  RepairedLabels repaired;
  std::vector<std::string> sentences;
};

/// Separates parts that touch by accident, such as two legs under a belly for lack of a stroke there.
///
/// A contact is a curve between parts A and B whose both ends lie on the same third part C, and on no other:
/// C surrounds it. It counts as accidental when it is at most `limit` of the boundary of A, and of that of B,
/// and no stroke touches its facets; the facets of A and B around it are then given to C. A step that would
/// leave more cross points or cut a part in two is not taken.
/// \pre repaired.labels are valid, see repair_labels
SeparatedLabels separate_contacts(const TriMesh& mesh, const std::vector<std::string>& names,
                                  const Seeds& seeds, RepairedLabels repaired,
                                  const std::vector<double>& boundary_costs, double limit);

}  // namespace partwise
