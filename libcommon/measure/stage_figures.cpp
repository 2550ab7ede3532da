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
  if (!parts.is_object() || parts.empty()) return false;
  int total = 0;
  for (const auto& [name, part] : parts.items()) {
    const Json folds = member(part, {"folds"});
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
  return figures;
}

}  // namespace partwise
