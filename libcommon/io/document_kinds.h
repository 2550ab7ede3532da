#pragma once

#include <string>
#include <vector>

namespace partwise::io {

/// A kind of document and the stage that makes it.
struct DocumentKind {
  std::string name;
  int major = 1;
  std::string stage;  ///< the tool, for messages
};

/// All kinds this version reads and writes.
const std::vector<DocumentKind>& document_kinds();

/// The kind called `name`, or nullptr.
const DocumentKind* find_kind(const std::string& name);

/// Whether documents of some kind have a metadata field of this name; others are only forwarded.
bool is_known_field(const std::string& name);

/// The kind of "partwise/<kind>-<major>". \throws InputError when it is unknown here, saying what to do.
const DocumentKind& kind_of_schema(const std::string& schema);

}  // namespace partwise::io
