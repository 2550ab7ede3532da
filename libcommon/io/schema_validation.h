#pragma once

#include <string>

#include "io/document.h"

namespace partwise::io {

/// Checks a document's metadata, a sketch or a measure against the schema that its member `schema` names.
/// \throws InputError as validate, and when `schema` is missing or unknown.
void validate_metadata(const Json& document);

/// Checks `document` against the schema of that name, such as "segment-1" (see schemas/).
/// \throws InputError with the path to the first value that does not fit and what is wrong with it.
void validate(const Json& document, const std::string& schema_name);

}  // namespace partwise::io
