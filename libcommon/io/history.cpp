#include <algorithm>
#include <string>

#include "error.h"
#include "io/document.h"

namespace partwise::io {
namespace {

[[noreturn]] void fail(std::size_t entry) {
  throw InputError("metadata /history/" + std::to_string(entry) +
                   ": must be an entry with indices of earlier ones in \"previous\"");
}

/// Appends `entry` unless an equal one is there; its index.
std::size_t add_once(Json& history, const Json& entry) {
  const auto found = std::find(history.begin(), history.end(), entry);
  if (found != history.end()) return static_cast<std::size_t>(found - history.begin());
  history.push_back(entry);
  return history.size() - 1;
}

/// Index in the merged history of the last entry of `added`, or -1 when that has none.
long merge(Json& history, const Json& added) {
  if (!added.is_array()) throw InputError("metadata /history: must be an array");
  std::vector<std::size_t> place;
  for (std::size_t i = 0; i < added.size(); ++i) {
    Json entry = added[i];
    if (!entry.is_object() || !entry.contains("previous") || !entry["previous"].is_array()) fail(i);
    for (Json& previous : entry["previous"]) {
      if (!previous.is_number_unsigned() || previous.get<std::size_t>() >= i) fail(i);
      previous = place[previous.get<std::size_t>()];
    }
    place.push_back(add_once(history, entry));
  }
  return place.empty() ? -1 : static_cast<long>(place.back());
}

}  // namespace

Json extend_history(const std::vector<const Document*>& inputs, const HistoryEntry& entry) {
  Json history = Json::array();
  Json previous = Json::array();
  Json identities = Json::array();
  for (const Document* input : inputs) {
    const long last = merge(history, input->metadata.value("history", Json::array()));
    if (last >= 0 && std::find(previous.begin(), previous.end(), Json(last)) == previous.end()) {
      previous.push_back(static_cast<std::size_t>(last));
    }
    identities.push_back(
        {{"sha256", digest(*input)}, {"schema", input->metadata.value("schema", "partwise/mesh-1")}});
  }
  for (const Json& identity : entry.further_inputs) identities.push_back(identity);
  history.push_back({{"tool", entry.tool},
                     {"version", PARTWISE_VERSION},
                     {"arguments", entry.arguments},
                     {"inputs", identities},
                     {"previous", previous}});
  return history;
}

}  // namespace partwise::io
