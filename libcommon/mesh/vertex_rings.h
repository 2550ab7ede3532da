#pragma once

#include <vector>

#include "mesh/types.h"

namespace partwise {

/// Some vertices of a mesh, one entry per vertex, and those that at most `rings` edges lead to from them.
/// \pre rings >= 0
std::vector<bool> within_rings(const Facets& facets, std::vector<bool> vertices, int rings);

}  // namespace partwise
