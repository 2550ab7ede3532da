#include "segmentation/contacts.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "error.h"
#include "mesh/segmentation.h"

namespace partwise {
namespace {

struct Contact {
  const BoundaryCurve* curve;
  int around;  ///< the part on both its ends
};

std::vector<double> boundary_lengths(const Segmentation& segmentation) {
  std::vector<double> lengths(segmentation.names.size(), 0);
  for (const BoundaryCurve& curve : segmentation.curves) {
    lengths[curve.left] += curve.length;
    if (curve.right != kOutside) lengths[curve.right] += curve.length;
  }
  return lengths;
}

/// The third part at a vertex where exactly three parts meet.
std::optional<int> third_part(const Segmentation& segmentation, int vertex, int a, int b) {
  const auto point = std::find_if(segmentation.cross_points.begin(), segmentation.cross_points.end(),
                                  [&](const CrossPoint& p) { return p.vertex == vertex; });
  if (point == segmentation.cross_points.end() || point->parts.size() != 3) return std::nullopt;
  for (const int part : point->parts) {
    if (part != a && part != b && part != kOutside) return part;
  }
  return std::nullopt;
}

std::vector<Contact> find_contacts(const Segmentation& segmentation, double limit) {
  const std::vector<double> lengths = boundary_lengths(segmentation);
  std::vector<Contact> contacts;
  for (const BoundaryCurve& curve : segmentation.curves) {
    if (curve.closed || curve.right == kOutside) continue;
    if (curve.length > limit * std::min(lengths[curve.left], lengths[curve.right])) continue;
    const auto first = third_part(segmentation, curve.vertices.front(), curve.left, curve.right);
    const auto last = third_part(segmentation, curve.vertices.back(), curve.left, curve.right);
    if (first && first == last) contacts.push_back({&curve, *first});
  }
  std::stable_sort(contacts.begin(), contacts.end(),
                   [](const Contact& a, const Contact& b) { return a.curve->length < b.curve->length; });
  return contacts;
}

/// The labels with the contact's surroundings given away; none when a stroke is in the way.
std::optional<std::vector<int>> given_away(const TriMesh& mesh, const Seeds& seeds,
                                           const Segmentation& segmentation, const Contact& contact) {
  std::vector<int> labels = segmentation.labels;
  for (const int v : contact.curve->vertices) {
    for (const auto f : mesh.half_edges().vf_range(OpenMesh::VertexHandle(v))) {
      if (segmentation.labels[f.idx()] == contact.around) continue;
      if (seeds.facet_part[f.idx()] != kUnseeded) return std::nullopt;
      labels[f.idx()] = contact.around;
    }
  }
  return labels;
}

std::string sentence(const Segmentation& segmentation, const Contact& contact) {
  const std::vector<int>& vertices = contact.curve->vertices;
  const std::string a = "'" + segmentation.names[contact.curve->left] + "'";
  const std::string b = "'" + segmentation.names[contact.curve->right] + "'";
  const std::string c = "'" + segmentation.names[contact.around] + "'";
  return "the parts " + a + " and " + b + " touched near vertex " +
         std::to_string(vertices[vertices.size() / 2]) + " and were separated by a strip of " + c +
         "; draw a stroke of " + c + " there, or strokes of both up to where they should meet";
}

/// Labels that are repaired, and their boundaries.
struct Separation {
  RepairedLabels repaired;
  Segmentation segmentation;
};

/// After separating one contact; none when that would not help.
std::optional<Separation> separated(const TriMesh& mesh, const Seeds& seeds, const Segmentation& segmentation,
                                    const Contact& contact, const std::vector<double>& boundary_costs) {
  std::optional<std::vector<int>> labels = given_away(mesh, seeds, segmentation, contact);
  if (!labels) return std::nullopt;
  try {
    RepairedLabels repaired =
        repair_labels(mesh, segmentation.names, seeds, std::move(*labels), boundary_costs);
    Segmentation after = trace_connected_parts(mesh, segmentation.names, repaired.labels);
    if (after.cross_points.size() >= segmentation.cross_points.size()) return std::nullopt;
    return Separation{std::move(repaired), std::move(after)};
  } catch (const Error&) {
    return std::nullopt;  // a part used up, or a pinch that stays: the contact stays, too
  }
}

}  // namespace

SeparatedLabels separate_contacts(const TriMesh& mesh, const std::vector<std::string>& names,
                                  const Seeds& seeds, RepairedLabels repaired,
                                  const std::vector<double>& boundary_costs, double limit) {
  SeparatedLabels result{std::move(repaired), {}};
  Segmentation segmentation = trace_connected_parts(mesh, names, result.repaired.labels);
  bool changed = true;
  while (changed) {
    changed = false;
    for (const Contact& contact : find_contacts(segmentation, limit)) {
      auto next = separated(mesh, seeds, segmentation, contact, boundary_costs);
      if (!next) continue;
      result.repaired.labels = std::move(next->repaired.labels);
      result.repaired.merged_islands += next->repaired.merged_islands;
      result.repaired.removed_pinches += next->repaired.removed_pinches;
      result.repaired.changed_facets += next->repaired.changed_facets;
      result.sentences.push_back(sentence(segmentation, contact));
      segmentation = std::move(next->segmentation);
      changed = true;  // every step leaves fewer cross points, so this ends
      break;
    }
  }
  return result;
}

}  // namespace partwise
