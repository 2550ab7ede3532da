#pragma once

#include <vector>

#include "mapping/model_pair.h"

namespace partwise {

/// A boundary curve of the source and the curve of the target that it goes to.
struct CurvePair {
  int source_curve = 0;
  int target_curve = 0;
  bool reversed = false;  ///< walked against its order, the source's curve keeps the same parts on its sides
                          ///< (and runs from the image of the target's first cross point to its last)
};

/// Pairs every boundary curve of the two models, in the order of the source's curves.
///
/// Closed curves are paired by the parts on their two sides; arcs as whole networks, so that the cyclic order
/// of parts around every N-cross point is kept. Where that leaves a choice (two loops between the same parts,
/// a network with a symmetry), anchors and markers on the curves decide, else the smallest distance after
/// `alignment`, which brings the source into the target's space.
/// \throws InputError naming the parts whose curves do not correspond.
std::vector<CurvePair> match_curves(const ModelPair& pair, const Eigen::Affine3d& alignment);

/// The vertices of a curve, backwards if `reversed` (a closed curve then keeps its first vertex).
std::vector<int> walked(const BoundaryCurve& curve, bool reversed);

/// Point halfway along an arc, or centroid of a closed curve, by length.
Vec3 curve_centre(const TriMesh& mesh, const BoundaryCurve& curve);

}  // namespace partwise
