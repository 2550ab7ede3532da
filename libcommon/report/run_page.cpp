#include "report/run_page.h"

#include "measure/figures_table.h"
#include "report/findings.h"
#include "report/page.h"
#include "report/run_surfaces.h"

namespace partwise::report {

using io::Json;

namespace {

Json history_of(const Json& metadata) {
  const Json history = metadata.value("history", Json::array());
  return history.is_array() ? history : Json::array();
}

// Marks `entry` and all that it came from.
void mark(const Json& history, std::size_t entry, const std::string& side, std::vector<std::string>& sides) {
  if (entry >= sides.size()) return;
  sides[entry] = side;
  for (const Json& previous : history[entry].value("previous", Json::array())) {
    if (previous.is_number_unsigned() && previous.get<std::size_t>() < entry) {
      mark(history, previous.get<std::size_t>(), side, sides);
    }
  }
}

// Per entry: "source" or "target" where it came before both met.
std::vector<std::string> sides_of(const Json& history) {
  std::vector<std::string> sides(history.size());
  for (std::size_t i = 0; i < history.size(); ++i) {
    const Json previous = history[i].value("previous", Json::array());
    if (history[i].value("tool", "") != "hull-to-hull" || previous.size() != 2) continue;
    mark(history, previous[0].get<std::size_t>(), "source", sides);
    mark(history, previous[1].get<std::size_t>(), "target", sides);
  }
  return sides;
}

Json profile_of(const Json& metrics, const std::string& side, const std::string& tool) {
  const Json::json_pointer place =
      Json::json_pointer() / "metrics" / (side.empty() ? tool : side) / (side.empty() ? "profile" : tool);
  const Json::json_pointer profile = side.empty() ? place : place / "profile";
  return metrics.contains(profile) ? metrics.at(profile) : Json::object();
}

void add_history(const Json& metadata, const std::string& side_of_all, const Json& measure, Json& rows) {
  const Json history = history_of(metadata);
  const std::vector<std::string> sides = sides_of(history);
  for (std::size_t i = 0; i < history.size(); ++i) {
    const std::string tool = history[i].value("tool", "");
    Json profile = profile_of(metadata, sides[i], tool);
    if (profile.empty() && measure.is_object()) profile = profile_of(measure, sides[i], tool);
    rows.push_back({{"tool", tool},
                    {"side", side_of_all.empty() ? sides[i] : side_of_all},
                    {"version", history[i].value("version", "")},
                    {"arguments", history[i].value("arguments", Json::object())},
                    {"inputs", history[i].value("inputs", Json::array())},
                    {"seconds", profile.value("seconds", Json())},
                    {"peak_memory_mb", profile.value("peak_memory_mb", Json())}});
  }
}

}  // namespace

Json run_history(const RunDocuments& run) {
  Json rows = Json::array();
  if (!run.measure.is_null() && history_of(run.measure).size() > history_of(run.last_metadata()).size()) {
    Json metadata = run.last_metadata();
    metadata["history"] = run.measure.at("history");
    add_history(metadata, "", run.measure, rows);
    return rows;
  }
  const bool met = run.cross_map || run.reconstructed || run.critical || run.compatible;
  if (met) {
    add_history(run.last_metadata(), "", {}, rows);
    return rows;
  }
  // Two models that have not met have a history each.
  for (const auto& [first, side] : {std::pair(0, "source"), {3, "target"}}) {
    for (int i = 2; i >= 0; --i) {
      if (!run.stages[first + i].trouble.empty()) continue;
      add_history(run.stages[first + i].metadata, side, {}, rows);
      break;
    }
  }
  return rows;
}

Json page_figures(const Json& measure) {
  Json rows = Json::array();
  if (!measure.is_object()) return rows;
  for (const FigureRow& row : figure_rows(measure)) {
    rows.push_back(
        {{"pointer", row.pointer}, {"heading", row.heading}, {"meaning", row.meaning}, {"value", row.value}});
  }
  return rows;
}

Json page_findings(const RunDocuments& run) {
  Json rows = Json::array();
  for (const Finding& finding : findings(run)) {
    rows.push_back({{"weight", name_of(finding.weight)}, {"stage", finding.stage}, {"text", finding.text}});
  }
  return rows;
}

std::string run_page(const RunDocuments& run, const RunPageOptions& options) {
  PageArrays arrays;
  Json facts = run_surfaces(run, options.most_facets, arrays);
  facts["name"] = run.name;
  facts["version"] = PARTWISE_VERSION;
  facts["figures"] = page_figures(run.measure);
  facts["one_to_one"] = run.measure.is_object() ? run.measure.value("one_to_one", Json()) : Json();
  facts["findings"] = page_findings(run);
  facts["history"] = run_history(run);
  facts["stages"] = Json::array();
  for (const StageState& stage : run.stages) {
    facts["stages"].push_back({{"title", stage.title}, {"trouble", stage.trouble}});
  }
  return html_page(Page::run, run.name + " - partwise", facts, arrays);
}

}  // namespace partwise::report
