#include "segmentation/compatibility.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "mesh/part.h"
#include "segmentation/landmarks.h"

namespace partwise {
namespace {

using PartPair = std::pair<std::string, std::string>;
constexpr const char* kOutsideName = "outside";

/// The topology of a segmentation in terms of part names.
struct Facts {
  std::vector<std::string> names;                       ///< sorted
  std::map<PartPair, int> curves;                       ///< number of boundary curves
  std::map<PartPair, int> example;                      ///< a vertex on one of them
  std::map<std::string, std::pair<int, int>> topology;  ///< loops and genus per part
  std::map<std::vector<std::string>, int> cross_points;
  std::map<std::string, PartPair> anchors;
  std::set<std::string> markers;
};

/// Of two single parts both take the same name: they correspond whatever they are called.
std::string name_of(const Segmentation& segmentation, int part, bool is_only_part) {
  if (part == kOutside) return kOutsideName;
  return is_only_part ? "whole" : segmentation.names[part];
}

PartPair sorted_pair(std::string a, std::string b) {
  if (b < a) std::swap(a, b);
  return {std::move(a), std::move(b)};
}

/// The cyclic word that starts at its smallest rotation, so that equal cycles compare equal.
std::vector<std::string> smallest_rotation(std::vector<std::string> word) {
  std::vector<std::string> best = word;
  for (std::size_t i = 1; i < word.size(); ++i) {
    std::rotate(word.begin(), word.begin() + 1, word.end());
    best = std::min(best, word);
  }
  return best;
}

std::pair<int, int> loops_and_genus(const SegmentedModel& model, int k) {
  const Part part = extract_part(model, k);
  return {static_cast<int>(part.loops.size()), (2 - part.mesh.euler_characteristic()) / 2};
}

Facts facts_of(const SegmentedModel& model, bool is_only_part) {
  const Segmentation& segmentation = model.segmentation;
  auto name = [&](int part) { return name_of(segmentation, part, is_only_part); };
  Facts facts;
  for (int part = 0; part < segmentation.part_count(); ++part) {
    facts.names.push_back(name(part));
    facts.topology[name(part)] = loops_and_genus(model, part);
  }
  std::sort(facts.names.begin(), facts.names.end());
  for (const BoundaryCurve& curve : segmentation.curves) {
    const PartPair pair = sorted_pair(name(curve.left), name(curve.right));
    ++facts.curves[pair];
    facts.example.emplace(pair, curve.vertices.front());
  }
  for (const CrossPoint& point : segmentation.cross_points) {
    std::vector<std::string> word;
    for (const int part : point.parts) word.push_back(name(part));
    ++facts.cross_points[smallest_rotation(std::move(word))];
  }
  for (const Anchor& anchor : model.anchors) {
    if (anchor.proposed) continue;  // decides nothing
    facts.anchors[anchor.name] = sorted_pair(name(anchor.part_a), name(anchor.part_b));
  }
  for (const Marker& marker : model.markers) facts.markers.insert(marker.name);
  return facts;
}

std::string quoted(const std::string& name) {
  return "'" + name + "'";
}

std::string quoted(const PartPair& pair) {
  return quoted(pair.first) + " and " + quoted(pair.second);
}

/// "1 curve", "2 curves"
std::string counted(int count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

void compare_parts(const Facts& a, const Facts& b, const char* side, std::vector<std::string>& differences) {
  for (const std::string& name : a.names) {
    if (!b.topology.contains(name)) {
      differences.push_back("part " + quoted(name) + " exists only in the " + side + " model");
    }
  }
}

void compare_topology(const Facts& a, const Facts& b, std::vector<std::string>& differences) {
  for (const auto& [name, first] : a.topology) {
    const auto second = b.topology.find(name);
    if (second == b.topology.end()) continue;
    const auto [loops_a, genus_a] = first;
    const auto [loops_b, genus_b] = second->second;
    if (loops_a != loops_b) {
      differences.push_back("part " + quoted(name) + " has " + counted(loops_a, "boundary loop") +
                            " in the first model and " + std::to_string(loops_b) + " in the second");
    }
    if (genus_a != genus_b) {
      differences.push_back("part " + quoted(name) + " has genus " + std::to_string(genus_a) +
                            " in the first model and " + std::to_string(genus_b) + " in the second");
    }
  }
}

void compare_curves(const Facts& a, const Facts& b, std::vector<std::string>& differences) {
  std::set<PartPair> pairs;
  for (const auto& [pair, count] : a.curves) pairs.insert(pair);
  for (const auto& [pair, count] : b.curves) pairs.insert(pair);
  auto known = [](const Facts& facts, const std::string& name) {
    return name == kOutsideName || facts.topology.contains(name);
  };
  for (const PartPair& pair : pairs) {
    const bool comparable =
        known(a, pair.first) && known(a, pair.second) && known(b, pair.first) && known(b, pair.second);
    const int in_a = a.curves.contains(pair) ? a.curves.at(pair) : 0;
    const int in_b = b.curves.contains(pair) ? b.curves.at(pair) : 0;
    if (!comparable || in_a == in_b) continue;
    if (in_a > 0 && in_b > 0) {
      differences.push_back("the parts " + quoted(pair) + " share " + counted(in_a, "boundary curve") +
                            " in the first model (one through vertex " + std::to_string(a.example.at(pair)) +
                            ") and " + std::to_string(in_b) + " in the second (vertex " +
                            std::to_string(b.example.at(pair)) + ")");
    } else {
      const Facts& where = in_a > 0 ? a : b;
      differences.push_back("the parts " + quoted(pair) + " meet only in the " +
                            (in_a > 0 ? "first" : "second") + " model (at vertex " +
                            std::to_string(where.example.at(pair)) + ")");
    }
  }
}

void compare_cross_points(const Facts& a, const Facts& b, std::vector<std::string>& differences) {
  std::set<std::vector<std::string>> words;
  for (const auto& [word, count] : a.cross_points) words.insert(word);
  for (const auto& [word, count] : b.cross_points) words.insert(word);
  for (const auto& word : words) {
    const int in_a = a.cross_points.contains(word) ? a.cross_points.at(word) : 0;
    const int in_b = b.cross_points.contains(word) ? b.cross_points.at(word) : 0;
    if (in_a == in_b) continue;
    std::string list;
    for (const std::string& name : word) list += (list.empty() ? "" : ", ") + quoted(name);
    differences.push_back("the parts " + list + " (counterclockwise) meet in " + counted(in_a, "point") +
                          " of the first model and " + std::to_string(in_b) + " of the second");
  }
}

void compare_landmarks(const Facts& a, const Facts& b, const char* side,
                       std::vector<std::string>& differences) {
  for (const auto& [name, parts] : a.anchors) {
    if (!b.anchors.contains(name)) {
      differences.push_back("anchor " + quoted(name) + " exists only in the " + side + " model");
    }
  }
  for (const std::string& name : a.markers) {
    if (!b.markers.contains(name)) {
      differences.push_back("marker " + quoted(name) + " exists only in the " + side + " model");
    }
  }
}

void compare_anchor_parts(const Facts& a, const Facts& b, std::vector<std::string>& differences) {
  for (const auto& [name, parts] : a.anchors) {
    const auto other = b.anchors.find(name);
    if (other == b.anchors.end() || other->second == parts) continue;
    differences.push_back("anchor " + quoted(name) + " lies between " + quoted(parts) +
                          " in the first model and between " + quoted(other->second) + " in the second");
  }
}

std::set<std::string> part_names_at(const SegmentedModel& model, const Marker& marker, bool is_only_part) {
  std::set<std::string> names;
  for (const int part : parts_at(model.mesh, model.segmentation, marker.point)) {
    names.insert(name_of(model.segmentation, part, is_only_part));
  }
  return names;
}

}  // namespace

std::vector<std::string> compare_segmentations(const SegmentedModel& a, const SegmentedModel& b) {
  const bool single = a.segmentation.part_count() == 1 && b.segmentation.part_count() == 1;
  const Facts first = facts_of(a, single), second = facts_of(b, single);
  std::vector<std::string> differences;
  compare_parts(first, second, "first", differences);
  compare_parts(second, first, "second", differences);
  compare_topology(first, second, differences);
  compare_curves(first, second, differences);
  compare_cross_points(first, second, differences);
  compare_landmarks(first, second, "first", differences);
  compare_landmarks(second, first, "second", differences);
  compare_anchor_parts(first, second, differences);
  return differences;
}

std::vector<std::string> misplaced_markers(const SegmentedModel& a, const SegmentedModel& b) {
  const bool single = a.segmentation.part_count() == 1 && b.segmentation.part_count() == 1;
  std::vector<std::string> sentences;
  for (const Marker& marker : a.markers) {
    const auto other = std::find_if(b.markers.begin(), b.markers.end(),
                                    [&](const Marker& m) { return m.name == marker.name; });
    if (other == b.markers.end()) continue;
    const std::set<std::string> first = part_names_at(a, marker, single);
    const std::set<std::string> second = part_names_at(b, *other, single);
    const bool shared = std::any_of(first.begin(), first.end(),
                                    [&](const std::string& name) { return second.contains(name); });
    if (shared) continue;
    sentences.push_back("marker " + quoted(marker.name) + " lies in part " + quoted(*first.begin()) +
                        " of the first model and in " + quoted(*second.begin()) + " of the second");
  }
  return sentences;
}

}  // namespace partwise
