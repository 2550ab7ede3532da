#pragma once

#include <vector>

#include "remeshing/compatible_mesh.h"

namespace partwise {

/// Per source facet: how much larger its part is on the target than on the source, as a length; what
/// relaxations take for the size of a facet.
std::vector<double> part_scales(const CompatibleMesh& mesh);

}  // namespace partwise
