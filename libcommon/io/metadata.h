#pragma once

#include <string>
#include <vector>

#include "io/document.h"

/// How a document's metadata is written down and found again; `document.h` is the way in.
namespace partwise::io {

/// SHA-256 of the tables as write_ply puts them, comments aside.
std::string tables_sha256(const PlyTables& tables);

/// The metadata of a document as written: with `tables_sha256`, and `history` and `metrics` at the least.
Json complete_metadata(const Document& document);

/// The one text of equal metadata: sorted keys, no spaces, ASCII.
std::string canonical_text(const Json& metadata);

/// The text of a sidecar file.
std::string sidecar_text(const Json& metadata);

/// PLY comments that hold the metadata, each line at most 1,000 bytes, with its SHA-256.
std::vector<std::string> embedding_comments(const Json& metadata);

/// The PLY comment that names a sidecar.
std::string sidecar_comment(const std::string& sidecar);

/// What the comments of a PLY say of its metadata; `other` comments are not ours.
struct MetadataComments {
  bool embedded = false;
  std::string text;            ///< of the embedded metadata
  std::string sidecar_sha256;  ///< empty when no sidecar is named
  std::vector<std::string> other;
};

/// \throws InputError when embedded metadata is damaged.
MetadataComments parse_comments(const std::vector<std::string>& comments);

/// \throws InputError when `text` is no JSON object.
Json parse_metadata(const std::string& text);

}  // namespace partwise::io
