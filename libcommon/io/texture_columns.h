#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/ply.h"
#include "mesh/texture_corners.h"

/// Texture coordinates in a PLY, as MeshLab and others write them: `face` has a list `texcoord` of u and v
/// per corner and, with several images, their numbers `texnumber`, which count the comments "TextureFile
/// NAME".
namespace partwise::io {

/// None when `face` has no list `texcoord`.
/// \throws InputError naming the row that has not six numbers
std::optional<TextureCorners> read_texture(const PlyTables& tables);

/// The columns `texcoord` (float) and, with several images, `texnumber`.
std::vector<Property> texture_columns(const TextureCorners& texture);

/// The comments that name the images, which belong into every file with these coordinates.
std::vector<std::string> texture_comments(const PlyTables& tables);

}  // namespace partwise::io
