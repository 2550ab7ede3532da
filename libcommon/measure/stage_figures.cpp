#include "measure/stage_figures.h"

namespace partwise {
namespace {

using io::Json;

/// The member at `path`, or null.
Json member(Json object, std::initializer_list<const char*> path) {
  for (const char* key : path) {
    if (!object.is_object() || !object.contains(key)) return nullptr;
    object = Json(object[key]);
  }
  return object;
}

bool is_true(const Json& value) {
  return value.is_boolean() && value.get<bool>();
}

/// Folds by the part's name, null when they are not known.
Json folds_by_part(const Json& metrics) {
  const Json by_name = member(metrics, {"hull_folds", "parts"});
  if (by_name.is_object()) return by_name;
  const Json parts = member(metrics, {"parts"});
  if (!parts.is_array()) return nullptr;
  Json folds = Json::object();
  for (const Json& part : parts) {
    const Json name = member(part, {"name"});
    if (!name.is_string()) return nullptr;
    folds[name.get<std::string>()] = member(part, {"folds"});
  }
  return folds;
}

/// Adds the folds of one hull map. \return false when they are not known
bool add_map(const Json& metrics, HullFoldCounts& counts) {
  const Json parts = folds_by_part(metrics);
  if (!parts.is_object() || parts.empty()) return false;
  int total = 0;
  for (const auto& [name, folds] : parts.items()) {
    if (!folds.is_number_integer()) return false;
    total += folds.get<int>();
    counts.parts[name] += folds.get<int>();
  }
  counts.total += total;
  counts.certified = counts.certified && total == 0 && is_true(member(metrics, {"one_to_one"}));
  return true;
}

}  // namespace

StageFigures stage_figures(const Json& metrics) {
  StageFigures figures;
  HullFoldCounts counts;
  if (add_map(member(metrics, {"source", "map-to-hull"}), counts) &&
      add_map(member(metrics, {"target", "map-to-hull"}), counts) &&
      add_map(member(metrics, {"hull-to-hull"}), counts)) {
    figures.hull_folds = counts;
  }
  const Json gap = member(metrics, {"reconstruct", "boundary_gap_max"});
  if (gap.is_number()) figures.boundary_gap_max = gap.get<double>();
  const char* last = member(metrics, {"relocate"}).is_null() ? "reconstruct" : "relocate";
  figures.one_to_one = is_true(member(metrics, {last, "one_to_one"}));
  return figures;
}

}  // namespace partwise
