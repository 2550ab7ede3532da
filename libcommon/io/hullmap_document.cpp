#include <utility>

#include "io/domain_tables.h"
#include "io/model_tables.h"
#include "io/stage_documents.h"

namespace partwise::io {

Document to_document(const HullMap& map) {
  Document document{{}, new_metadata("hullmap-1")};
  document.metadata.update(model_facts(map.hulled.model));
  PlyTables& tables = document.tables;
  add_images(tables, map.hulled.parts, map.images, "vertex", "mesh_vertex");
  add_part_facets(tables, map.hulled.parts, "face", "mesh_face");
  add_model(tables, map.hulled.model, kMeshElements);
  add_hulls(tables, map.hulled.hulls, "hull_vertex", "hull_face");
  return document;
}

HullMap read_hull_map(const Document& document) {
  const PlyTables& tables = document.tables;
  HulledModel hulled = read_hulls_of(read_model(tables, JsonReader(document.metadata), kMeshElements), tables,
                                     "hull_vertex", "hull_face");
  std::vector<Points> images = read_images(tables, hulled.parts, "vertex", "mesh_vertex");
  require_part_facets(tables, hulled.parts, "face", "mesh_face");
  return {std::move(hulled), std::move(images)};
}

}  // namespace partwise::io
