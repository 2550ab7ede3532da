#pragma once

#include <vector>

#include "mesh/tri_mesh.h"

namespace partwise {

/// Per facet the smallest facet that it hangs together with, from edge to edge through facets of its label.
/// \param labels per facet; empty: all are equal
std::vector<int> facet_regions(const TriMesh& mesh, const std::vector<int>& labels);

}  // namespace partwise
