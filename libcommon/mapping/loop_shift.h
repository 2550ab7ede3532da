#pragma once

#include "mapping/boundary_correspondence.h"

namespace partwise {

/// The turn of a closed curve onto another that gives the smallest sum of squared distances between points at
/// equal fractions of length, both curves brought to one centre and size.
///
/// `source` is in the target's space already, walked in the target's direction; both are closed polygons that
/// do not repeat their first point. Turns that bring the first source vertex onto a target vertex are tried,
/// and 256 between; so a copy finds itself exactly. \param diagonal the target model's, the unit of distances
LoopShift best_shift(const Points& source, const Points& target, double diagonal);

/// The same for a given turn: its distance, and the best other one.
LoopShift given_shift(const Points& source, const Points& target, double diagonal, double shift);

}  // namespace partwise
