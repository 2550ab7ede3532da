#pragma once

#include "mesh/types.h"

namespace partwise {

/// A model's surface area, of which the square root is its size: unlike a bounding box it does not depend on
/// how the model lies.
double surface_area(const Points& points, const Facets& facets);

/// `points` scaled to the size of `first`, turned so that vertices come nearest to it in the mean, and moved
/// so that their means are one. \pre the same number of vertices; facets name them
Points aligned_model(const Points& points, const Points& first, const Facets& facets);

}  // namespace partwise
