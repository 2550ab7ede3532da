#pragma once

#include "remeshing/compatible_mesh.h"

namespace partwise::tests {

/// A torus onto a thicker one, each in two halves that meet twice: one chart per part, vertices added on
/// their common boundaries.
CompatibleMesh torus_pair();

}  // namespace partwise::tests
