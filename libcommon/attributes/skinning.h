#pragma once

#include <string>
#include <vector>

#include "attributes/origins.h"
#include "io/ply.h"
#include "mesh/tri_mesh.h"

namespace partwise {

/// The columns that bind vertices to a skeleton: per vertex some joints and as many weights. Either scalars
/// joint_0, joint_1 ... and weight_0, weight_1 ..., or lists joints and weights; bone instead of joint is
/// understood.
struct SkinColumns {
  std::vector<const io::Property*> joints, weights;  ///< a pair of scalars each, or one pair of lists

  bool empty() const { return joints.empty(); }
  bool contains(const io::Property& property) const;
};

SkinColumns find_skin(const io::Element& vertices);

/// Skinning weights at the origins: a joint's weight is interpolated over the facet, whatever its place in
/// the corners' lists; the largest ones stay, as many as the giver has at most, with the same sum.
/// \throws InputError naming the row where the numbers of joints and weights differ
std::vector<io::Property> carry_skin(const SkinColumns& skin, const TriMesh& giver,
                                     const std::vector<SurfacePoint>& origins);

}  // namespace partwise
