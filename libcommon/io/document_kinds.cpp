#include "io/document_kinds.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "error.h"

namespace partwise::io {

const std::vector<DocumentKind>& document_kinds() {
  static const std::vector<DocumentKind> kinds{
      {"mesh", 1, "convert-mesh"},   {"segment", 1, "segment"},       {"hull", 1, "hull"},
      {"hullmap", 1, "map-to-hull"}, {"crossmap", 1, "hull-to-hull"}, {"compatible", 1, "reconstruct"}};
  return kinds;
}

const DocumentKind* find_kind(const std::string& name) {
  const std::vector<DocumentKind>& kinds = document_kinds();
  const auto found =
      std::find_if(kinds.begin(), kinds.end(), [&](const auto& kind) { return kind.name == name; });
  return found == kinds.end() ? nullptr : &*found;
}

bool is_known_field(const std::string& name) {
  constexpr std::array<std::string_view, 16> kFields{
      "schema",       "history",   "metrics",        "tables_sha256", "parts",  "curves",
      "cross_points", "adjacency", "markers",        "anchors",       "source", "target",
      "source_parts", "charts",    "added_vertices", "proposed_cuts"};
  return std::find(kFields.begin(), kFields.end(), name) != kFields.end();
}

const DocumentKind& kind_of_schema(const std::string& schema) {
  const std::string prefix = "partwise/";
  const std::size_t dash = schema.rfind('-');
  if (schema.rfind(prefix, 0) != 0 || dash == std::string::npos || dash < prefix.size()) {
    throw InputError("the schema \"" + schema +
                     "\" is none of partwise: give a document that partwise wrote");
  }
  const DocumentKind* kind = find_kind(schema.substr(prefix.size(), dash - prefix.size()));
  if (!kind) {
    throw InputError("the schema \"" + schema +
                     "\" is of a kind that this version does not know: use a newer partwise");
  }
  if (schema.substr(dash + 1) != std::to_string(kind->major)) {
    throw InputError("the schema \"" + schema + "\" has another major version than the " +
                     std::to_string(kind->major) +
                     " that this version reads: use the partwise that wrote it, or " +
                     "make the document anew with " + kind->stage);
  }
  return *kind;
}

}  // namespace partwise::io
