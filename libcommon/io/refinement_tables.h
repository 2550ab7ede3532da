#pragma once

#include "io/document.h"
#include "remeshing/compatible_mesh.h"

/// What compatible-1 says of vertices added to the source: where they lie on the one that was read.
namespace partwise::io {

/// Adds the member `refined_vertices`, their number, and, if any were added, the elements `refined_vertex`
/// and `original_face` and the column `original_face` of `face`.
void add_refinement(Document& document, const CompatibleMesh& mesh);

/// Fills the refinement of `mesh`, whose other members are there; a document without the member
/// `refined_vertices` has none.
/// \throws InputError when the tables contradict each other: the refined source is not the original surface
void read_refinement(const Document& document, CompatibleMesh& mesh);

}  // namespace partwise::io
