#pragma once

#include "mesh/segmentation.h"
#include "remeshing/reconstruct.h"

/// Pairs of models mapped by all stages from `hull` to `reconstruct`.
namespace partwise::tests {

Reconstruction mapped_by_hulls(const SegmentedModel& source, const SegmentedModel& target);

/// A torus in two halves and a fatter, finer one: what meets at two loops has no common sphere, but a chart
/// per part.
CompatibleMesh torus_pair();

/// The mesh on itself, every vertex that is not at the boundary moved by up to `size` edge lengths over it.
CompatibleMesh shaken(const TriMesh& mesh, double size, unsigned seed);

}  // namespace partwise::tests
