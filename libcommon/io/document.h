#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

#include "io/ply.h"

namespace partwise::io {

using Json = nlohmann::json;

/// A mesh with tables plus metadata: what every stage reads and writes (one document in, one document out).
///
/// On disk `X.ply` with the sidecar `X.json`; in a pipe one PLY that carries the same JSON in its header.
/// `metadata` always has `schema` ("partwise/<kind>-<major>"), `history` and `metrics`; fields a reader does
/// not know are kept and forwarded.
struct Document {
  PlyTables tables;
  Json metadata = Json::object();

  /// "hullmap" for the schema "partwise/hullmap-1"; "mesh" for a bare PLY without metadata.
  std::string kind() const;
};

/// Reads `path`, or standard input for "-". A PLY without metadata is a "mesh" document.
///
/// The metadata comes from the PLY header when it is there, else from the sidecar beside the file.
/// \throws IoError when the file cannot be opened; InputError for a broken PLY or JSON, a sidecar that
/// belongs to
///         another PLY, an unknown kind or major version, metadata that violates its schema.
Document read_document(const std::string& path);

/// Writes `path` (.ply) and its sidecar (.json), or one PLY with embedded metadata to standard output for
/// "-".
///
/// Files are written under a temporary name, flushed, then renamed: a killed process leaves no half file.
/// \throws IoError, also when `path` exists and `overwrite` is false.
void write_document(const std::string& path, const Document& document, bool overwrite);

/// SHA-256 that identifies a document's content: the same for the file pair and for the piped form.
std::string digest(const Document& document);

/// What a tool did, for the append-only history of the document it writes.
struct HistoryEntry {
  std::string tool;
  Json arguments = Json::object();  ///< option -> value, defaults left out; no paths
};

/// Merges the inputs' histories (equal entries once) and appends `entry`, with the digests of the inputs.
Json extend_history(const std::vector<const Document*>& inputs, const HistoryEntry& entry);

}  // namespace partwise::io
