#include "report/batch_page.h"

#include <algorithm>
#include <filesystem>

#include "error.h"
#include "report/page.h"
#include "report/run_page.h"
#include "report/run_surfaces.h"

namespace partwise::report {

namespace fs = std::filesystem;
using io::Json;

namespace {

// "failed", "warnings" or "done", the gravest of the findings.
std::string verdict(const Json& findings) {
  std::string result = "done";
  for (const Json& finding : findings) {
    if (finding.at("weight") == "failure") return "failed";
    if (finding.at("weight") == "warning") result = "warnings";
  }
  return result;
}

Json row_of(const std::string& folder, DisplayMeshes& displays, PageArrays& arrays) {
  const std::string name = fs::path(folder).filename().string();
  Json row{{"name", name}, {"figures", Json::array()}};
  const fs::path page = fs::path(folder) / "report.html";
  row["link"] = fs::exists(page) ? Json(name + "/report.html") : Json();
  try {
    const RunDocuments run = read_run(run_places(folder), RunDepth::result);
    row["figures"] = page_figures(run.measure);
    row["findings"] = page_findings(run);
    const Json shown = thumbnail_surfaces(run, displays, arrays);
    row["surfaces"] = shown.at("surfaces");
    row["parts"] = shown.at("parts");
  } catch (const Error& error) {
    row["findings"] = {{{"weight", "failure"}, {"stage", ""}, {"text", error.what()}}};
  }
  row["verdict"] = verdict(row["findings"]);
  return row;
}

}  // namespace

std::vector<std::string> run_folders(const std::string& folder) {
  if (!fs::is_directory(folder)) {
    throw IoError(folder + ": is no folder; name the one that holds the pairs");
  }
  std::vector<std::string> folders;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (is_run_folder(entry.path().string())) folders.push_back(entry.path().string());
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

std::string batch_page(const std::string& folder, const BatchPageOptions& options) {
  const std::vector<std::string> folders = run_folders(folder);
  if (folders.empty()) {
    throw InputError(folder + ": holds no pair; name the folder that batch.mk wrote to");
  }
  DisplayMeshes displays(options.thumbnail_facets);
  PageArrays arrays;
  Json rows = Json::array();
  for (const std::string& run : folders) rows.push_back(row_of(run, displays, arrays));
  const std::string name = (fs::absolute(folder) / "").lexically_normal().parent_path().filename().string();
  return html_page(Page::batch, name + " - partwise",
                   {{"name", name}, {"version", PARTWISE_VERSION}, {"rows", rows}}, arrays);
}

}  // namespace partwise::report
