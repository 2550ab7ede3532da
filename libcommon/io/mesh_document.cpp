#include "io/model_tables.h"
#include "io/stage_documents.h"
#include "io/table_builder.h"

namespace partwise::io {

Document to_document(const TriMesh& mesh) {
  Document document{{}, new_metadata("mesh-1")};
  document.tables.elements = {ElementBuilder("vertex", mesh.vertex_count()).points(mesh.points()).build(),
                              ElementBuilder("face", mesh.facet_count()).facets(mesh.facets()).build()};
  return document;
}

TriMesh read_mesh(const Document& document) {
  return read_mesh(document.tables, "vertex", "face");
}

}  // namespace partwise::io
