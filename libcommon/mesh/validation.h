#pragma once

#include <string>
#include <vector>

#include "mesh/types.h"

namespace partwise {

/// What is wrong with a triangle soup that should be an oriented 2-manifold, one sentence per defect.
///
/// Checked, in this order (later checks need the earlier ones to hold): at least one facet; finite positions;
/// vertex indices in range; facets with a repeated vertex; duplicate facets; edges with more than two facets;
/// edges whose two facets have opposite orientations; vertices whose facets form more than one fan; vertices
/// without a facet. Indices in the sentences are 0-based, in the order of the file. Each kind of defect is
/// described by its first occurrence and its count.
std::vector<std::string> find_defects(const Points& points, const Facets& facets);

}  // namespace partwise
