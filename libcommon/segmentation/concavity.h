#pragma once

#include <string>
#include <vector>

#include "mesh/segmentation.h"

namespace partwise {

/// Per part: how far its vertices are from its convex hull, over the mesh's diagonal ([Wu11] 4.2). A flat
/// part counts as convex.
std::vector<Concavity> measure_concavity(const TriMesh& mesh, const Segmentation& segmentation);

/// One sentence per part whose concavity exceeds `tau`: where to decompose it further.
std::vector<std::string> decomposition_hints(const Segmentation& segmentation,
                                             const std::vector<Concavity>& concavity, double tau);

}  // namespace partwise
