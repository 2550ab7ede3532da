#include "cli/forwarding.h"

#include "io/document_kinds.h"

namespace partwise::cli {
namespace {

using io::Json;

Json unknown_fields(const Json& metadata) {
  Json fields = Json::object();
  for (const auto& [name, value] : metadata.items()) {
    if (!io::is_known_field(name)) fields[name] = value;
  }
  return fields;
}

std::string role(std::size_t input, std::size_t count) {
  if (count > 2) return "input-" + std::to_string(input);
  return input == 0 ? "source" : "target";
}

}  // namespace

void forward_metadata(Json& metadata, const std::vector<const io::Document*>& inputs, const std::string& tool,
                      const Json& metrics) {
  const Json own = metadata;
  Json all_metrics = Json::object();
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const Json& input = inputs[i]->metadata;
    const Json input_metrics = input.value("metrics", Json::object());
    if (inputs.size() == 1) {
      all_metrics = input_metrics;
    } else {
      all_metrics[role(i, inputs.size())] = input_metrics;
    }
    const Json unknown = unknown_fields(input);
    for (const auto& [name, value] : unknown.items()) {
      if (own.contains(name)) continue;
      bool in_all = true;
      for (const io::Document* other : inputs)
        in_all = in_all && other->metadata.value(name, Json()) == value;
      if (in_all) {
        metadata[name] = value;
      } else {
        metadata["inputs"][role(i, inputs.size())][name] = value;
      }
    }
  }
  if (!metrics.empty()) all_metrics[tool] = metrics;
  metadata["metrics"] = all_metrics;
}

}  // namespace partwise::cli
