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
/// `metadata` always has `schema` ("partwise/<kind>-<major>"), `history` and `metrics`; one that was read or
/// written also `tables_sha256`. Fields a reader does not know are kept and forwarded.
struct Document {
  PlyTables tables;
  Json metadata = Json::object();

  /// "hullmap" for the schema "partwise/hullmap-1"; "mesh" for a bare PLY without metadata.
  std::string kind() const;
};

/// Reads `path`, or standard input for "-". A PLY without metadata of ours is a "mesh" document.
///
/// The metadata comes from the PLY's header when it is there, else from the sidecar that the header names.
/// \throws IoError when a file cannot be opened or read; InputError for a broken PLY or JSON, a sidecar or
///         metadata that belong to another PLY, an unknown kind or major version. The messages name the file.
Document read_document(const std::string& path);

/// Writes `path` (.ply) and its sidecar (.json), or one PLY with embedded metadata for "-" (standard output)
/// and for paths that are no regular file (a FIFO).
///
/// Files are written without a name beside the output, flushed, then named: a killed process leaves no half
/// file, and a pair of which only one file could be replaced is refused by read_document.
/// \throws IoError, also as require_writable; BrokenPipe when the reader of a pipe has ended.
void write_document(const std::string& path, const Document& document, bool overwrite);

/// \throws UsageError when `path` is no name for a document (X.ply or "-"), IoError when it or its sidecar
///         exists and `overwrite` is false, or the sidecar's place is taken by a file of another kind.
void require_writable(const std::string& path, bool overwrite);

/// SHA-256 that identifies a document's content: the same for the file pair and for the piped form.
///
/// A document that was read already knows the SHA-256 of its tables: after changes to them, remove the field
/// `tables_sha256` first.
std::string digest(const Document& document);

/// What a tool did, for the append-only history of the document it writes.
struct HistoryEntry {
  std::string tool;
  Json arguments = Json::object();      ///< option -> value, defaults left out; no paths
  Json further_inputs = Json::array();  ///< {"sha256", "schema"} of inputs that are no documents (sketches)
};

/// Merges the inputs' histories (equal entries once) and appends `entry`, with the digests of the inputs.
///
/// An entry has `tool`, `version`, `arguments`, `inputs` and `previous`, the indices of the entries that made
/// the inputs. The last entry is the one that made the document.
/// \throws InputError when an input's history is no such array.
Json extend_history(const std::vector<const Document*>& inputs, const HistoryEntry& entry);

}  // namespace partwise::io
