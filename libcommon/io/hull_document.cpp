#include "io/domain_tables.h"
#include "io/model_tables.h"
#include "io/stage_documents.h"

namespace partwise::io {

Document to_document(const HulledModel& hulled) {
  Document document{{}, new_metadata("hull-1")};
  document.metadata.update(model_facts(hulled.model));
  add_hulls(document.tables, hulled.hulls, "vertex", "face", true);
  add_model(document.tables, hulled.model, kMeshElements);
  return document;
}

HulledModel read_hulled_model(const Document& document) {
  return read_hulls_of(read_model(document.tables, JsonReader(document.metadata), kMeshElements),
                       document.tables, "vertex", "face");
}

}  // namespace partwise::io
