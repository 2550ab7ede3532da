#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "io/ply.h"
#include "mesh/texture_corners.h"

/// Import and export of meshes in the formats of other programs.
namespace partwise::io {

/// A mesh as a file of another program has it: vertices and facets in the file's order, nothing repaired.
struct ImportedMesh {
  Points points;
  Facets facets;
  long polygons = 0;                        ///< facets with more than three corners, cut into triangles
  long merged_vertices = 0;                 ///< STL: corners that were equal to an earlier one
  std::optional<TextureCorners> texture{};  ///< OBJ's vt, PLY's texcoord
  long bare_facets = 0;                     ///< OBJ: those without vt where others have some; at (0, 0)
  std::vector<std::string> ignored;         ///< what else the file has, such as "vertex property red"
};

/// Reads OBJ, OFF or STL (ASCII or binary), by the ending of `path`. OBJ's vertices count from 1 in the file
/// and from 0 here; its materials become numbers of images in the order of their first use, when there are
/// several; .mtl files, normals and groups are ignored.
/// \throws IoError; InputError naming the file and its line (or facet) of the first fault.
ImportedMesh import_mesh(const std::string& path);

/// The geometry of a PLY: element `vertex` (x, y, z of any type) and `face` (vertex_indices or vertex_index),
/// with the facets' texture coordinates (see texture_columns.h). \throws InputError naming element, row and
/// property.
ImportedMesh import_ply(const PlyTables& tables);

ImportedMesh read_obj(std::istream& in);
ImportedMesh read_off(std::istream& in);
ImportedMesh read_stl(std::istream& in);

/// Whether `path` ends in .obj, .off or .stl, in any case.
bool is_foreign_mesh_file(const std::string& path);

/// Writes .obj, .off, .stl (binary, float) or a .ply without metadata, by the ending of `path`. Vertices and
/// facets keep their order; coordinates but for STL's read back equal. OBJ and PLY hold the texture, if any:
/// OBJ as vt with one number for corners of a vertex that agree, and materials image_0, image_1 ... where
/// there are several images; no .mtl is written.
/// \throws IoError, also when the file exists and `overwrite` is false.
void export_mesh(const std::string& path, const Points& points, const Facets& facets, bool overwrite,
                 const std::optional<TextureCorners>& texture = {});

}  // namespace partwise::io
