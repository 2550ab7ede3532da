#pragma once

#include <string>
#include <vector>

#include "attributes/origins.h"
#include "io/ply.h"
#include "mesh/tri_mesh.h"

namespace partwise {

/// Columns for the receiver's `vertex` and `face`.
struct CarriedAttributes {
  std::vector<io::Property> vertex;
  std::vector<io::Property> face;
};

/// Everything that a PLY says of a mesh besides its geometry, for another mesh.
///
/// `vertex`: real numbers and colours are interpolated over the facet; other integers (labels) and lists are
/// those of the nearest corner; skinning weights see carry_skin. `face`: real numbers and colours are the
/// mean over the facet's samples, other integers the most frequent value (the smallest of equals), lists
/// those of the facet with most samples; `texcoord`, with `texnumber`, see carry_texture.
/// \param properties names of the columns wanted; empty for all
/// \throws InputError when one of them is missing, or a column has not a row for each vertex or facet
CarriedAttributes carry_attributes(const io::PlyTables& from, const TriMesh& giver, const TriMesh& receiver,
                                   const Origins& origins, const std::vector<std::string>& properties = {});

}  // namespace partwise
