#include "io/schema_validation.h"

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <vector>

#include "error.h"
#include "io/embedded_schemas.h"

namespace partwise::io {
namespace {

using Adapter = valijson::adapters::NlohmannJsonAdapter;

const std::string kPrefix = "partwise/";
const std::string kEnding = ".schema.json";

/// \param name such as "segment-1"
Json schema_text(const std::string& name) {
  const auto found = embedded_schemas().find(name + kEnding);
  if (found == embedded_schemas().end()) {
    std::string known;
    for (const auto& [file, text] : embedded_schemas()) {
      if (file.starts_with("common")) continue;
      known += (known.empty() ? "" : ", ") + kPrefix + file.substr(0, file.find(kEnding));
    }
    throw InputError("metadata /schema: '" + kPrefix + name + "' is not known to this version; it knows " +
                     known);
  }
  return Json::parse(found->second);
}

/// For references from one schema into another: "common-1.schema.json".
const Json* fetch_schema(const std::string& uri) {
  return new Json(schema_text(uri.substr(0, uri.find(kEnding))));
}

void free_schema(const Json* schema) {
  delete schema;
}

/// {"<root>", "[parts]", "[3]", "[name]"} as /parts/3/name.
std::string json_pointer(const std::vector<std::string>& context) {
  std::string path;
  for (std::size_t i = 1; i < context.size(); ++i) {
    path += "/" + context[i].substr(1, context[i].size() - 2);
  }
  return path.empty() ? "/" : path;
}

/// What is wrong with the innermost value that does not fit: the reasons given for the values around it only
/// repeat that something inside is wrong.
std::string explanation(valijson::ValidationResults& results) {
  std::vector<valijson::ValidationResults::Error> errors(results.begin(), results.end());
  const auto innermost = std::max_element(errors.begin(), errors.end(), [](const auto& a, const auto& b) {
    return a.context.size() < b.context.size();
  });
  std::vector<std::string> reasons;
  for (const auto& error : errors) {
    std::string reason = error.description;
    if (!reason.empty() && reason.back() == '.') reason.pop_back();
    const bool is_new = std::find(reasons.begin(), reasons.end(), reason) == reasons.end();
    if (error.context == innermost->context && is_new) reasons.push_back(reason);
  }
  std::string text = "metadata " + json_pointer(innermost->context) + ": ";
  for (const std::string& reason : reasons) text += (&reason == &reasons.front() ? "" : "; ") + reason;
  return text;
}

}  // namespace

void validate(const Json& document, const std::string& schema_name) {
  const Json text = schema_text(schema_name);
  valijson::Schema schema;
  valijson::SchemaParser parser;
  parser.populateSchema(Adapter(text), schema, fetch_schema, free_schema);
  valijson::Validator validator;
  valijson::ValidationResults results;
  if (!validator.validate(schema, Adapter(document), &results)) throw InputError(explanation(results));
}

void validate_metadata(const Json& document) {
  const auto schema = document.is_object() ? document.find("schema") : document.end();
  if (schema == document.end() || !schema->is_string()) {
    throw InputError("metadata /schema: the name of the document's schema, such as \"" + kPrefix +
                     "segment-1\", is missing");
  }
  const auto name = schema->get<std::string>();
  if (name.rfind(kPrefix, 0) != 0) {
    throw InputError("metadata /schema: '" + name + "' does not begin with " + kPrefix);
  }
  validate(document, name.substr(kPrefix.size()));
}

}  // namespace partwise::io
