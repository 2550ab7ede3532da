#include "io/model_tables.h"
#include "io/stage_documents.h"

namespace partwise::io {
namespace {

const ModelElements kElements{"vertex", "face", "curve"};

}  // namespace

Document to_document(const SegmentedModel& model) {
  Document document{{}, new_metadata("segment-1")};
  document.metadata.update(model_facts(model));
  add_model(document.tables, model, kElements, true);
  return document;
}

SegmentedModel read_segmented_model(const Document& document) {
  return read_model(document.tables, JsonReader(document.metadata), kElements);
}

}  // namespace partwise::io
