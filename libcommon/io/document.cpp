#include "io/document.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <utility>

#include "error.h"
#include "io/document_kinds.h"
#include "io/metadata.h"
#include "io/pending_file.h"
#include "io/schema_validation.h"
#include "io/sha256.h"

namespace partwise::io {
namespace {

std::string sidecar_path(const std::string& path) {
  return std::filesystem::path(path).replace_extension(".json").string();
}

bool exists(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::exists(path, ignored);
}

std::ifstream open_file(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) throw IoError("is a folder: give a file");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw IoError(std::string("cannot be opened: ") + std::strerror(errno ? errno : EIO));
  return file;
}

std::string read_sidecar(const std::string& path, const std::string& expected_sha256) {
  const std::string sidecar = sidecar_path(path);
  if (path == "-") {
    throw InputError("the PLY names a sidecar (.json), which a pipe cannot carry: give the file by its name");
  }
  if (!exists(sidecar)) {
    throw InputError("its sidecar " + sidecar + " is missing: keep the .ply and the .json together");
  }
  std::ifstream file = open_file(sidecar);
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (file.bad()) throw IoError("the sidecar " + sidecar + " cannot be read");
  if (sha256(text) != expected_sha256) {
    throw InputError("its sidecar " + sidecar +
                     " belongs to another PLY or was changed: make the pair anew, or restore the sidecar");
  }
  return text;
}

void check_metadata(const Document& document) {
  const Json& metadata = document.metadata;
  const auto schema = metadata.find("schema");
  if (schema == metadata.end() || !schema->is_string()) throw InputError("the metadata names no schema");
  kind_of_schema(schema->get<std::string>());
  validate_metadata(metadata);
  if (metadata.value("tables_sha256", Json()) != tables_sha256(document.tables)) {
    throw InputError(
        "the tables of the PLY are not those that its metadata was written for: the file was "
        "changed or damaged; make it anew");
  }
}

Document read_from(std::istream& in, const std::string& path) {
  Document document{read_ply(in), Json::object()};
  MetadataComments comments = parse_comments(document.tables.comments);
  document.tables.comments = std::move(comments.other);
  if (comments.embedded) {
    document.metadata = parse_metadata(comments.text);
  } else if (!comments.sidecar_sha256.empty()) {
    document.metadata = parse_metadata(read_sidecar(path, comments.sidecar_sha256));
  } else {
    document.metadata = complete_metadata(document);
    return document;
  }
  check_metadata(document);
  return document;
}

std::vector<std::string> with_comments(std::vector<std::string> ours, const PlyTables& tables) {
  ours.insert(ours.end(), tables.comments.begin(), tables.comments.end());
  return ours;
}

/// Whether a sidecar of ours, which may be replaced, is at `path`; anything else a user may still need.
bool holds_metadata(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  const Json found = Json::parse(file, nullptr, false);
  return found.is_object() && found.contains("tables_sha256");
}

}  // namespace

std::string Document::kind() const {
  const auto schema = metadata.find("schema");
  return schema == metadata.end() ? "mesh" : kind_of_schema(schema->get<std::string>()).name;
}

Document read_document(const std::string& path) {
  const std::string name = path == "-" ? "standard input" : path;
  try {
    if (path == "-") return read_from(std::cin, path);
    std::ifstream file = open_file(path);
    return read_from(file, path);
  } catch (const InputError& error) {
    throw InputError(name + ": " + error.what());
  } catch (const IoError& error) {
    throw IoError(name + ": " + error.what());
  }
}

void require_writable(const std::string& path, bool overwrite) {
  if (path == "-" || is_special_file(path)) return;
  if (std::filesystem::path(path).extension() != ".ply") {
    throw UsageError("the output " + path + " must end in .ply (its sidecar .json is written beside)");
  }
  for (const std::string& name : {path, sidecar_path(path)}) {
    if (exists(name) && !overwrite) {
      throw IoError(name + ": exists already: give --force to replace it");
    }
  }
  const std::string sidecar = sidecar_path(path);
  if (exists(sidecar) && !holds_metadata(sidecar)) {
    throw IoError(sidecar + ": is no sidecar of partwise and would be lost: choose another output");
  }
}

void write_document(const std::string& path, const Document& document, bool overwrite) {
  require_writable(path, overwrite);
  const Json metadata = complete_metadata(document);
  if (path == "-" || is_special_file(path)) {
    const std::vector<std::string> comments = with_comments(embedding_comments(metadata), document.tables);
    write_through(path, [&](std::ostream& out) { write_ply(out, document.tables, comments); });
    return;
  }
  const std::string text = sidecar_text(metadata);
  PendingFile sidecar(sidecar_path(path));
  PendingFile ply(path);
  sidecar.fill([&](std::ostream& out) { out << text; });
  ply.fill([&](std::ostream& out) {
    write_ply(out, document.tables, with_comments({sidecar_comment(text)}, document.tables));
  });
  // The PLY comes last: with a new sidecar alone, the pair is refused rather than misread.
  sidecar.commit(overwrite);
  ply.commit(overwrite);
}

std::string digest(const Document& document) {
  if (document.metadata.contains("tables_sha256")) return sha256(canonical_text(document.metadata));
  return sha256(canonical_text(complete_metadata(document)));
}

}  // namespace partwise::io
