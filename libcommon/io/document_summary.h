#pragma once

#include <string>

#include "io/document.h"

namespace partwise::io {

/// A document as text for people: kind and digest, elements with their columns, the facts of the kind,
/// metrics, and the history, oldest first, each entry with its arguments and what it was made from.
std::string summary(const Document& document);

/// Checks everything that can be checked of a document on its own: metadata against the schema, tables
/// against the metadata and against each other (see stage_documents.h).
/// \throws InputError
void check_document(const Document& document);

}  // namespace partwise::io
