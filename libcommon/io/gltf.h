#pragma once

#include <array>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "mesh/texture_corners.h"

namespace partwise::io {

/// A mesh that changes its shape in time.
struct ShapeAnimation {
  std::string name;  ///< of the mesh
  Facets facets;
  std::vector<Points> frames;  ///< one or more, over the same vertices; the mesh at rest is the first
  std::vector<std::string> frame_names;                ///< one per frame
  double seconds = 0;                                  ///< from the first frame to the last, evenly
  std::vector<std::array<std::uint8_t, 3>> colours{};  ///< per vertex red, green, blue (sRGB), or empty
  std::optional<TextureCorners> texture{};             ///< of one image: numbers of images are left out
  bool z_is_up = false;                                ///< glTF's own upward axis is y
};

/// Writes one binary glTF 2.0 file (.glb): the first frame as the mesh, the others as morph targets with
/// positions and normals, and an animation of their weights that goes from frame to frame in straight steps.
/// Vertices at seams of the texture are doubled, behind all others (split_at_seams); their normals stay those
/// of the whole surface. Positions become float. Blender, three.js, Windows' and macOS' viewers, assimp read
/// it. \pre sizes agree \throws InputError when the file would exceed glTF's 4 GB, IoError when the stream
/// fails
void write_glb(std::ostream& out, const ShapeAnimation& animation);

}  // namespace partwise::io
