#pragma once

#include "mapping/boundary_correspondence.h"

namespace partwise {

/// Decides by distortion how closed curves without anchors are turned.
///
/// `boundary` has them turned as the models lie (match_boundaries). From there other turns by eighths of the
/// curve are tried, for one curve after the other: the two parts beside it are drawn to their places on the
/// target's hulls, and the turn that strains them least is taken if it does so clearly, else the one that was
/// there. The strains are reported as LoopShift::strain and rival_strain. Curves beside a part that folds on
/// its own hull stay as they are.
BoundaryCorrespondence choose_turns(const ModelPair& pair, const HullMap& source, const HullMap& target,
                                    BoundaryCorrespondence boundary);

/// No turn is clearly better than another one: anchors should say which is meant.
bool is_uncertain(const LoopShift& shift);

}  // namespace partwise
