#pragma once

#include "segmentation/label_repair.h"

namespace partwise {

/// Gives every ear, a facet with two edges on the boundary to one other part, to that part.
///
/// The three corners of an ear lie on the boundary: where another model's boundary bends the other way there,
/// no map that keeps boundaries could leave the facet unfolded. Each step shortens the boundary and changes
/// neither its topology nor any part's. A facet that a stroke gave to its part stays, so do ears at cross
/// points and at the mesh's own boundary.
/// \pre repaired.labels are valid, see repair_labels
RepairedLabels remove_ears(const TriMesh& mesh, const Seeds& seeds, RepairedLabels repaired);

}  // namespace partwise
