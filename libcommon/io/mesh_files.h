#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "io/ply.h"
#include "mesh/types.h"

/// Import and export of meshes in the formats of other programs.
namespace partwise::io {

/// A mesh as a file of another program has it: vertices and facets in the file's order, nothing repaired.
struct ImportedMesh {
  Points points;
  Facets facets;
  long polygons = 0;                 ///< facets with more than three corners, cut into triangles
  long merged_vertices = 0;          ///< STL: corners that were equal to an earlier one
  std::vector<std::string> ignored;  ///< what else the file has, such as "vertex property red"
};

/// Reads OBJ, OFF or STL (ASCII or binary), by the ending of `path`. OBJ's vertices count from 1 in the file
/// and from 0 here; texture coordinates, normals, groups and materials are ignored.
/// \throws IoError; InputError naming the file and its line (or facet) of the first fault.
ImportedMesh import_mesh(const std::string& path);

/// The geometry of a PLY: element `vertex` (x, y, z of any type) and `face` (vertex_indices or vertex_index).
/// \throws InputError naming element, row and property.
ImportedMesh import_ply(const PlyTables& tables);

ImportedMesh read_obj(std::istream& in);
ImportedMesh read_off(std::istream& in);
ImportedMesh read_stl(std::istream& in);

/// Whether `path` ends in .obj, .off or .stl, in any case.
bool is_foreign_mesh_file(const std::string& path);

/// Writes .obj, .off, .stl (binary, float) or a .ply without metadata, by the ending of `path`. Vertices and
/// facets keep their order; coordinates but for STL's read back equal.
/// \throws IoError, also when the file exists and `overwrite` is false.
void export_mesh(const std::string& path, const Points& points, const Facets& facets, bool overwrite);

}  // namespace partwise::io
