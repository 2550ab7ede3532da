#include "report/findings.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace partwise::report {

using io::Json;
using Weight = Finding::Weight;

namespace {

std::string counted(long number, const std::string& singular, const std::string& plural) {
  return std::to_string(number) + " " + (number == 1 ? singular : plural);
}

std::string percent(double share) {
  char text[40];
  std::snprintf(text, sizeof text, "%.2g\u00a0%%", 100 * share);
  return text;
}

// A member of any depth, or null.
Json at(const Json& document, const std::string& pointer) {
  const Json::json_pointer place(pointer);
  return document.contains(place) ? document.at(place) : Json();
}

double number(const Json& document, const std::string& pointer) {
  const Json value = at(document, pointer);
  return value.is_number() ? value.get<double>() : 0;
}

class Findings {
 public:
  explicit Findings(const RunDocuments& run) : run_(run), metrics_(at(run.last_metadata(), "/metrics")) {}

  std::vector<Finding> all() && {
    add_stages();
    add_lineage();
    add_hull_maps("source");
    add_hull_maps("target");
    add_crossing();
    add_result();
    std::stable_sort(found_.begin(), found_.end(),
                     [](const Finding& a, const Finding& b) { return a.weight < b.weight; });
    return std::move(found_);
  }

 private:
  void add(Weight weight, const std::string& stage, const std::string& text) {
    found_.push_back({weight, stage, text});
  }

  // Of a finished pair the intermediate documents may be missing: a shell pipeline keeps none.
  void add_stages() {
    const bool finished = run_.compatible && run_.measure.is_object();
    for (const StageState& stage : run_.stages) {
      if (stage.missing && finished) {
        add(Weight::note, stage.title,
            "There is no " + stage.file + ": this stage was not kept, and cannot be shown.");
      } else if (stage.missing) {
        add(Weight::failure, stage.title,
            "There is no " + stage.file + ": this stage has not been made, or it failed.");
      } else if (!stage.trouble.empty()) {
        add(Weight::failure, stage.title, stage.file + ": " + stage.trouble + ".");
      }
    }
  }

  // Whether the document of `stage` names that of `input` among what it was made from.
  void add_parent(const StageState& stage, const StageState& input) {
    if (!stage.trouble.empty() || !input.trouble.empty() || input.digest.empty()) return;
    const Json history = at(stage.metadata, "/history");
    if (!history.is_array() || history.empty()) return;
    for (const Json& parent : history.back().value("inputs", Json::array())) {
      if (parent.value("sha256", "") == input.digest) return;
    }
    add(Weight::warning, stage.title,
        "This document was made from another version of \"" + input.title +
            "\" than the one shown; make the pair again.");
  }

  void add_lineage() {
    const auto& s = run_.stages;
    for (const auto& [child, parent] :
         {std::pair(1, 0), {2, 1}, {4, 3}, {5, 4}, {6, 2}, {6, 5}, {7, 6}, {8, 7}, {9, 8}, {10, 9}}) {
      add_parent(s[child], s[parent]);
    }
  }

  void add_hull_maps(const std::string& side) {
    const Json parts = at(metrics_, "/" + side + "/map-to-hull/parts");
    if (!parts.is_object()) return;
    const std::string stage = "map-to-hull (" + side + ")";
    for (const auto& [name, part] : parts.items()) {
      if (const double folds = number(part, "/folds"); folds > 0) {
        add(Weight::warning, stage,
            "The part \"" + name + "\" has " + counted(std::lround(folds), "folded facet", "folded facets") +
                " on its hull.");
      }
      if (part.contains("remark")) {
        add(Weight::note, stage, "The part \"" + name + "\" " + part.at("remark").get<std::string>() + ".");
      }
    }
  }

  void add_crossing() {
    const Json parts = at(metrics_, "/hull-to-hull/parts");
    if (!parts.is_object()) return;
    for (const auto& [name, part] : parts.items()) {
      if (const double folds = number(part, "/folds"); folds > 0) {
        add(Weight::warning, "hull-to-hull",
            "The part \"" + name + "\" has " + counted(std::lround(folds), "folded facet", "folded facets") +
                " on the target's hull.");
      }
      for (const Json& marker : part.value("released_markers", Json::array())) {
        add(Weight::warning, "hull-to-hull",
            "The marker \"" + marker.get<std::string>() +
                "\" could not be held without a fold: check that it is the same place on both models.");
      }
    }
    for (const Json& curve : at(metrics_, "/hull-to-hull/turned_curves")) {
      add(Weight::note, "hull-to-hull",
          "A boundary without anchors" + between(curve) + " was turned by " +
              percent(number(curve, "/shift")) +
              " of its length to its best fit; anchors would say how it belongs.");
    }
  }

  static std::string between(const Json& curve) {
    return " between \"" + curve.value("left", "") + "\" and \"" + curve.value("right", "") + "\"";
  }

  void add_result() {
    const Json& m = run_.measure;
    if (!m.is_object()) return;
    if (!m.value("one_to_one", Json(false)).get<bool>()) {
      const Json reason = at(m, "/certificate/reason");
      add(Weight::warning, "measure",
          "The map is not certified one-to-one" +
              (reason.is_string() ? ": " + reason.get<std::string>() : "") + ".");
    }
    const auto count = [&](const char* pointer) { return std::lround(number(m, pointer)); };
    if (const long flipped = count("/flipped_faces"); flipped > 0) {
      add(Weight::warning, "measure",
          counted(flipped, "facet faces", "facets face") + " against the target (" +
              percent(static_cast<double>(flipped) / std::max(1.0, number(m, "/source_faces"))) + ").");
    }
    if (const long flat = count("/degenerate_faces"); flat > 0) {
      add(Weight::warning, "measure", counted(flat, "facet has", "facets have") + " no area.");
    }
    const long own = std::max(count("/self_intersections/source"), count("/self_intersections/target"));
    if (const long pairs = count("/self_intersections/compatible"); pairs > own) {
      add(Weight::note, "measure",
          counted(pairs, "pair", "pairs") + " of facets intersect; source and target have " +
              std::to_string(count("/self_intersections/source")) + " and " +
              std::to_string(count("/self_intersections/target")) + " of their own.");
    }
    const Json undefined = at(m, "/undefined");
    if (!undefined.is_object()) return;
    for (const auto& [figure, reason] : undefined.items()) {
      add(Weight::note, "measure", "No figure \"" + figure + "\": " + reason.get<std::string>() + ".");
    }
  }

  const RunDocuments& run_;
  Json metrics_;
  std::vector<Finding> found_;
};

}  // namespace

std::vector<Finding> findings(const RunDocuments& run) {
  return Findings(run).all();
}

const char* name_of(Weight weight) {
  if (weight == Weight::failure) return "failure";
  return weight == Weight::warning ? "warning" : "note";
}

}  // namespace partwise::report
