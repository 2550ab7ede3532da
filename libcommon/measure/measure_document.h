#pragma once

#include "io/document.h"
#include "measure/measurement.h"
#include "measure/stage_figures.h"

namespace partwise {

/// The document partwise/measure-1 without its history: every figure of `measurement` and `stages`, distances
/// over the target's diagonal.
///
/// A figure that is not defined is null, and `undefined` says why, by the figure's name; there is never a
/// number that is not finite.
io::Json measure_document(const Measurement& measurement, const StageFigures& stages);

}  // namespace partwise
