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

/// Adds the folds of one hull map. \return false when they are not known
bool add_map(const Json& metrics, HullFoldCounts& counts) {
  const Json parts = member(metrics, {"parts"});
  if (!parts.is_structured() || parts.empty()) return false;
  for (const auto& [key, part] : parts.items()) {
    const Json name = parts.is_array() ? member(part, {"name"}) : Json(key);
    const Json folds = member(part, {"folds"});
    if (!name.is_string() || !folds.is_number_integer()) return false;
    counts.total += folds.get<int>();
    counts.parts[name.get<std::string>()] += folds.get<int>();
    counts.certified = counts.certified && folds == 0 && is_true(member(part, {"one_to_one"}));
  }
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
