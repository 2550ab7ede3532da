#pragma once

#include "attributes/origins.h"
#include "mesh/texture_corners.h"
#include "mesh/tri_mesh.h"

namespace partwise {

/// The texture coordinates that a model takes over through a map.
///
/// A facet of the receiver takes all its corners from one side of the seams: from the facets of the giver
/// around the one that it has most samples in, as far as coordinates go on without a jump. A corner that lies
/// beyond a seam takes the nearest place before it. So seams follow edges of the receiver, and no facet
/// spreads over the image. A seam that ends inside a facet's image is not noticed.
TextureCorners carry_texture(const TextureCorners& given, const TriMesh& giver, const TriMesh& receiver,
                             const Origins& origins);

}  // namespace partwise
