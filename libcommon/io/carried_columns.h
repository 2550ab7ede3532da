#pragma once

#include <string>

#include "io/document.h"

namespace partwise::io {

/// Adds to an element what its namesake in another document says of the same rows besides the geometry:
/// colours, labels, weights, texture coordinates and so on. Positions, normals, corners and the columns that
/// are a compatible mesh's map are left out, as are columns that are there already.
/// \pre both elements have the same number of rows
void carry_columns(Element& to, const Element& from);

/// Whether a column of `vertex` or `face` says where things are, not what they are like.
bool is_geometry(const std::string& property);

}  // namespace partwise::io
