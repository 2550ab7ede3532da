#include "io/metadata.h"

#include <algorithm>
#include <ostream>

#include "error.h"
#include "io/sha256.h"

namespace partwise::io {
namespace {

const std::string kEmbeddedMark = "partwise metadata sha256:";
const std::string kTextMark = "partwise json ";
const std::string kSidecarMark = "partwise sidecar sha256:";
constexpr std::size_t kLongestLine = 1000;  // with "comment " before and the line feed after

bool begins_with(const std::string& text, const std::string& mark) {
  return text.compare(0, mark.size(), mark) == 0;
}

std::string text_of(const Json& metadata, int indent) {
  return metadata.dump(indent, ' ', true, Json::error_handler_t::replace);
}

/// Spaces occur only within strings; escaped, no tool that trims lines can harm them.
std::string without_spaces(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == ' ') {
      result += "\\u0020";
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace

std::string tables_sha256(const PlyTables& tables) {
  Sha256 hash;
  std::ostream out(&hash);
  write_ply(out, tables, {});
  return hash.hex();
}

Json complete_metadata(const Document& document) {
  Json metadata = document.metadata;
  if (!metadata.contains("schema")) metadata["schema"] = "partwise/mesh-1";
  if (!metadata.contains("history")) metadata["history"] = Json::array();
  if (!metadata.contains("metrics")) metadata["metrics"] = Json::object();
  metadata["tables_sha256"] = tables_sha256(document.tables);
  return metadata;
}

std::string canonical_text(const Json& metadata) {
  return text_of(metadata, -1);
}

std::string sidecar_text(const Json& metadata) {
  return text_of(metadata, 2) + "\n";
}

std::vector<std::string> embedding_comments(const Json& metadata) {
  const std::string text = without_spaces(canonical_text(metadata));
  const std::size_t room = kLongestLine - std::string("comment \n").size() - kTextMark.size();
  std::vector<std::string> comments{kEmbeddedMark + sha256(text)};
  for (std::size_t begin = 0; begin < text.size(); begin += room) {
    comments.push_back(kTextMark + text.substr(begin, room));
  }
  return comments;
}

std::string sidecar_comment(const std::string& sidecar) {
  return kSidecarMark + sha256(sidecar);
}

MetadataComments parse_comments(const std::vector<std::string>& comments) {
  MetadataComments result;
  std::string checksum;
  for (const std::string& comment : comments) {
    if (begins_with(comment, kEmbeddedMark)) {
      result.embedded = true;
      checksum = comment.substr(kEmbeddedMark.size());
    } else if (begins_with(comment, kTextMark)) {
      result.text += comment.substr(kTextMark.size());
    } else if (begins_with(comment, kSidecarMark)) {
      result.sidecar_sha256 = comment.substr(kSidecarMark.size());
    } else if (begins_with(comment, "partwise ")) {
      throw InputError("the header has the unknown comment \"" + comment.substr(0, 60) +
                       "\": the file is damaged, or of a newer partwise");
    } else {
      result.other.push_back(comment);
    }
  }
  if (result.embedded ? sha256(result.text) != checksum : !result.text.empty()) {
    throw InputError("the metadata in the header is damaged (its checksum differs): make the document anew");
  }
  return result;
}

Json parse_metadata(const std::string& text) {
  try {
    Json metadata = Json::parse(text);
    if (!metadata.is_object()) throw InputError("the metadata is no JSON object");
    return metadata;
  } catch (const Json::exception& error) {
    throw InputError(std::string("the metadata is no JSON: ") + error.what());
  }
}

}  // namespace partwise::io
