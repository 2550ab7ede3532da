#pragma once

#include "geometry/mean_value_weights.h"
#include "mesh/tri_mesh.h"

namespace partwise {

/// Undoes small folds of a map onto the sphere of directions: around the folded facets, vertices move to the
/// means of their neighbours, first in the nearest rings, then in wider ones. Each fold's surroundings are
/// changed only if fewer folds are left there, so folds never grow in number.
///
/// `weights` are positive and have the neighbours of vertex i in row i (see mean_value_weights). Directions
/// may have any length > 0; those that move come back with length 1. Not guaranteed: that no fold remains.
Points repair_folds(const Facets& facets, const VertexWeights& weights, const Points& directions);

}  // namespace partwise
