#pragma once

#include "segmentation/sketch.h"

namespace partwise {

/// Strokes for `part_count` parts where nobody drew any: a suggestion for a person to correct, no decision.
///
/// The core, named "core", lies around the vertex with the smallest mean way to all ends of the shape; the
/// others, "part 1" and so on, at ends of what sticks out, each the farthest from the core and those before:
/// tips of limbs, where the shape has that many. Strokes run along the ways between them. Horns, ears and
/// folds may win over legs; left and right are not told apart, so that names seldom correspond between
/// models. Unchanged by similarities and the same on every run.
/// \pre 2 <= part_count
/// \throws InputError when the mesh has several components, or too few vertices to keep the strokes apart
Sketch suggest_sketch(const TriMesh& mesh, int part_count);

}  // namespace partwise
