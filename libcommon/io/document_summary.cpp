#include "io/document_summary.h"

#include <array>
#include <sstream>

#include "io/schema_validation.h"
#include "io/stage_documents.h"

namespace partwise::io {
namespace {

constexpr std::size_t kLabelWidth = 18;
constexpr std::size_t kLongestValue = 200;

std::string label(const std::string& text) {
  return text + std::string(text.size() < kLabelWidth ? kLabelWidth - text.size() : 1, ' ');
}

const char* type_name(const Property& property) {
  constexpr std::array<const char*, 8> kNames{"int8",  "uint8",  "int16", "uint16",
                                              "int32", "uint32", "float", "double"};
  return kNames.at(property.values.index());
}

/// Columns of one type together: "x y z (double), part (int32)".
std::string columns(const Element& element) {
  std::string text, type;
  for (const Property& property : element.properties) {
    const std::string own = (property.is_list ? "lists of " : "") + std::string(type_name(property));
    if (!type.empty() && own != type) text += " (" + type + "),";
    text += " " + property.name;
    type = own;
  }
  return type.empty() ? text : text + " (" + type + ")";
}

std::string compact(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (text.size() <= kLongestValue) return text;
  return value.is_array() ? std::to_string(value.size()) + " entries"
                          : std::to_string(value.size()) + " members";
}

/// The names of the objects in an array, or "" when they have none.
std::string names(const Json& array) {
  std::string text;
  for (const Json& item : array) {
    if (!item.is_object() || !item.contains("name") || !item["name"].is_string()) return "";
    text += (text.empty() ? "" : ", ") + item["name"].get<std::string>();
  }
  return text;
}

void add_fact(std::ostream& out, const std::string& indent, const std::string& name, const Json& value) {
  if (value.is_object()) {
    out << indent << name << "\n";
    for (const auto& [key, member] : value.items()) add_fact(out, indent + "  ", key, member);
  } else if (value.is_array() && (value.empty() || value.front().is_object())) {
    const std::string listed = names(value);
    out << indent << label(name) << value.size() << (listed.empty() ? "" : ": " + listed) << "\n";
  } else {
    out << indent << label(name) << compact(value) << "\n";
  }
}

void add_history(std::ostream& out, const Json& history) {
  out << "history\n";
  for (std::size_t i = 0; i < history.size(); ++i) {
    const Json& entry = history[i];
    out << "  " << i << "  " << compact(entry.value("tool", Json("?"))) << " "
        << compact(entry.value("version", Json("?")));
    const Json arguments = entry.value("arguments", Json::object());
    for (const auto& [option, value] : arguments.items()) out << " " << option << " " << compact(value);
    out << "\n";
    const Json inputs = entry.value("inputs", Json::array());
    for (const Json& input : inputs) {
      out << "       from " << compact(input.value("schema", Json("?"))) << " "
          << compact(input.value("sha256", Json("?"))).substr(0, 12) << "\n";
    }
  }
}

}  // namespace

std::string summary(const Document& document) {
  const Json& metadata = document.metadata;
  std::ostringstream out;
  out << label("kind") << document.kind() << " (" << compact(metadata.value("schema", Json("bare PLY")))
      << ")\n";
  out << label("digest") << digest(document) << "\n";
  out << "elements\n";
  for (const Element& element : document.tables.elements) {
    out << "  " << label(element.name) << element.size << ":" << columns(element) << "\n";
  }
  for (const auto& [name, value] : metadata.items()) {
    const bool elsewhere = name == "schema" || name == "tables_sha256" || name == "history";
    if (!elsewhere && !(name == "metrics" && value.empty())) add_fact(out, "", name, value);
  }
  if (metadata.contains("history")) add_history(out, metadata["history"]);
  return out.str();
}

void check_document(const Document& document) {
  if (document.metadata.contains("schema")) validate_metadata(document.metadata);
  const std::string kind = document.kind();
  if (kind == "segment") read_segmented_model(document);
  if (kind == "hull") read_hulled_model(document);
  if (kind == "hullmap") read_hull_map(document);
  if (kind == "crossmap") read_cross_map(document);
  if (kind == "compatible") read_compatible_mesh(document);
  read_mesh(document);
}

}  // namespace partwise::io
