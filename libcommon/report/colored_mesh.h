#pragma once

#include "io/ply.h"
#include "measure/surface_field.h"
#include "report/panel.h"

namespace partwise::report {

/// The surface with its field as colours (viridis) and as the number `quality` per vertex, under which
/// MeshLab and others know it. Comments say what it is and which colours stand for which numbers.
io::PlyTables colored_mesh(const SurfaceField& field);

/// A mesh whose vertices have colours (`red green blue`, uchar), each facet in the mean of its corners'.
/// \throws InputError when the colours are missing or no triangles are there
Panel colored_panel(const io::PlyTables& tables);

/// Whether a mesh has colours at its vertices.
bool has_vertex_colors(const io::PlyTables& tables);

}  // namespace partwise::report
