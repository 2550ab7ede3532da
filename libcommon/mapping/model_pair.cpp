#include "mapping/model_pair.h"

#include <algorithm>
#include <map>
#include <optional>

#include "error.h"
#include "geometry/normals.h"
#include "mapping/alignment.h"

namespace partwise {
namespace {

std::string quoted(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "'" : ", '") + name + "'";
  return text;
}

void pair_parts(ModelPair& pair) {
  const Segmentation& source = pair.source.segmentation;
  const Segmentation& target = pair.target.segmentation;
  std::vector<std::string> only_source, only_target;
  for (const std::string& name : source.names) {
    pair.target_part.push_back(part_index(target, name));
    if (pair.target_part.back() < 0) only_source.push_back(name);
  }
  for (const std::string& name : target.names) {
    pair.source_part.push_back(part_index(source, name));
    if (pair.source_part.back() < 0) only_target.push_back(name);
  }
  // One part each is the same part, whatever it is called.
  if (source.part_count() == 1 && target.part_count() == 1) {
    pair.source_part = pair.target_part = {0};
    return;
  }
  if (only_source.empty() && only_target.empty()) return;
  std::string text = "the models have different parts:";
  if (!only_source.empty()) text += " only the source has " + quoted(only_source);
  if (!only_source.empty() && !only_target.empty()) text += ",";
  if (!only_target.empty()) text += " only the target has " + quoted(only_target);
  throw InputError(text + "; run segment --check on the two and give both sketches the same parts");
}

/// Calls use(source, target) for landmarks of equal names; names found once go into the warnings.
template <class Landmark, class Use>
void pair_by_name(const std::vector<Landmark>& source, const std::vector<Landmark>& target, const char* kind,
                  std::vector<std::string>& warnings, Use use) {
  std::map<std::string, const Landmark*> targets;
  for (const Landmark& landmark : target) targets.emplace(landmark.name, &landmark);
  std::vector<std::string> only_source, only_target;
  for (const Landmark& landmark : source) {
    const auto found = targets.find(landmark.name);
    if (found == targets.end()) {
      only_source.push_back(landmark.name);
    } else {
      use(landmark, *found->second);
      targets.erase(found);
    }
  }
  for (const Landmark& landmark : target) {
    if (targets.count(landmark.name)) only_target.push_back(landmark.name);
  }
  auto warn = [&](const std::vector<std::string>& names, const char* side) {
    if (names.empty()) return;
    warnings.push_back(std::string(kind) + (names.size() > 1 ? "s " : " ") + quoted(names) + " only on the " +
                       side + ": not used");
  };
  warn(only_source, "source");
  warn(only_target, "target");
}

/// The same point of the mesh in every facet that contains it: several on an edge or at a vertex.
std::vector<SurfacePoint> in_all_facets(const TriMesh& mesh, const SurfacePoint& point) {
  constexpr double kOnEdge = 1e-9;
  const Facet& facet = mesh.facet(point.facet);
  std::vector<int> corners;
  for (int i = 0; i < 3; ++i) {
    if (point.barycentric[i] > kOnEdge) corners.push_back(i);
  }
  if (corners.size() == 3) return {point};
  std::vector<SurfacePoint> result{point};
  for (const auto f : mesh.half_edges().vf_range(OpenMesh::VertexHandle(facet[corners.front()]))) {
    SurfacePoint other{f.idx(), Vec3::Zero()};
    std::size_t shared = 0;
    for (const int corner : corners) {
      for (int i = 0; i < 3; ++i) {
        if (mesh.facet(f.idx())[i] != facet[corner]) continue;
        other.barycentric[i] = point.barycentric[corner];
        ++shared;
      }
    }
    if (shared == corners.size() && f.idx() != point.facet) {
      other.barycentric /= other.barycentric.sum();
      result.push_back(other);
    }
  }
  return result;
}

std::optional<MarkerConstraint> constraint_of(const ModelPair& pair, int index) {
  const MarkerPair& marker = pair.markers[index];
  const auto in_target = in_all_facets(pair.target.mesh, marker.target);
  for (const SurfacePoint& s : in_all_facets(pair.source.mesh, marker.source)) {
    const int part = pair.in_target(pair.source.segmentation.labels[s.facet]);
    for (const SurfacePoint& t : in_target) {
      if (pair.target.segmentation.labels[t.facet] == part) return MarkerConstraint{index, part, s, t};
    }
  }
  return std::nullopt;
}

void constrain_markers(ModelPair& pair) {
  for (int i = 0; i < static_cast<int>(pair.markers.size()); ++i) {
    if (const auto constraint = constraint_of(pair, i)) {
      pair.marker_constraints.push_back(*constraint);
      continue;
    }
    const MarkerPair& marker = pair.markers[i];
    const Segmentation& source = pair.source.segmentation;
    const Segmentation& target = pair.target.segmentation;
    pair.warnings.push_back(
        "marker '" + marker.name + "' lies in part '" + source.names[source.labels[marker.source.facet]] +
        "' of the source but in part '" + target.names[target.labels[marker.target.facet]] +
        "' of the target: not used as a constraint");
  }
}

/// The vertex that a point of a mesh is, if it is one and lies on a boundary curve.
std::optional<int> curve_vertex(const SegmentedModel& model, const SurfacePoint& point) {
  Eigen::Index corner = 0;
  if (point.barycentric.maxCoeff(&corner) < 1 - 1e-9) return std::nullopt;
  const int vertex = model.mesh.facet(point.facet)[corner];
  for (const BoundaryCurve& curve : model.segmentation.curves) {
    if (std::count(curve.vertices.begin(), curve.vertices.end(), vertex)) return vertex;
  }
  return std::nullopt;
}

void add_markers_on_curves(ModelPair& pair) {
  for (const MarkerPair& marker : pair.markers) {
    const auto source = curve_vertex(pair.source, marker.source);
    const auto target = source ? curve_vertex(pair.target, marker.target) : std::nullopt;
    if (target) pair.anchors.push_back({marker.name, *source, *target, true});
  }
}

/// Proposals are for people to judge: they decide no correspondence.
std::vector<Anchor> given_anchors(const SegmentedModel& model) {
  std::vector<Anchor> anchors = model.anchors;
  std::erase_if(anchors, [](const Anchor& anchor) { return anchor.proposed; });
  return anchors;
}

/// Per part: centroid of its surface.
Points part_centroids(const SegmentedModel& model) {
  const Segmentation& segmentation = model.segmentation;
  const std::vector<double> areas = facet_areas(model.mesh.points(), model.mesh.facets());
  Points sums(segmentation.names.size(), Vec3::Zero());
  std::vector<double> weights(segmentation.names.size(), 0);
  for (int f = 0; f < model.mesh.facet_count(); ++f) {
    const int part = segmentation.labels[f];
    for (const int v : model.mesh.facet(f)) sums[part] += areas[f] / 3 * model.mesh.point(v);
    weights[part] += areas[f];
  }
  for (std::size_t k = 0; k < sums.size(); ++k) {
    if (weights[k] > 0) sums[k] /= weights[k];
  }
  return sums;
}

/// What the models have in common in space; `weight(part)` says how much a part (in the target's order)
/// counts.
template <class Weight>
MatchedPoints common_points(const ModelPair& pair, Weight weight) {
  MatchedPoints matched;
  const Points source = part_centroids(pair.source), target = part_centroids(pair.target);
  for (std::size_t k = 0; k < target.size(); ++k) {
    matched.add(source[pair.source_part[k]], target[k], weight(static_cast<int>(k)));
  }
  for (const MarkerConstraint& marker : pair.marker_constraints) {
    matched.add(position(pair.source.mesh, marker.source), position(pair.target.mesh, marker.target),
                weight(marker.part));
  }
  for (const AnchorPair& anchor : pair.anchors) {
    double largest = 0;
    for (const auto f :
         pair.target.mesh.half_edges().vf_range(OpenMesh::VertexHandle(anchor.target_vertex))) {
      largest = std::max<double>(largest, weight(pair.target.segmentation.labels[f.idx()]));
    }
    matched.add(pair.source.mesh.point(anchor.source_vertex), pair.target.mesh.point(anchor.target_vertex),
                largest);
  }
  return matched;
}

}  // namespace

int ModelPair::in_target(int part_of_source) const {
  return part_of_source == kOutside ? kOutside : target_part[part_of_source];
}

ModelPair pair_models(const SegmentedModel& source, const SegmentedModel& target) {
  ModelPair pair{source, target, {}, {}, {}, {}, {}, {}};
  pair_parts(pair);
  pair_by_name(given_anchors(source), given_anchors(target), "anchor", pair.warnings,
               [&](const Anchor& s, const Anchor& t) {
                 pair.anchors.push_back({s.name, s.vertex, t.vertex, false});
               });
  pair_by_name(source.markers, target.markers, "marker", pair.warnings,
               [&](const Marker& s, const Marker& t) {
                 pair.markers.push_back({s.name, s.point, t.point});
               });
  constrain_markers(pair);
  add_markers_on_curves(pair);
  return pair;
}

Eigen::Affine3d align_models(const ModelPair& pair) {
  Eigen::Affine3d upright = Eigen::Affine3d::Identity();
  upright.linear() *= pair.target.mesh.diagonal() / pair.source.mesh.diagonal();
  return fit_similarity(common_points(pair, [](int) { return 1.0; }), upright);
}

Eigen::Affine3d align_around(const ModelPair& pair, const std::vector<int>& parts,
                             const Eigen::Affine3d& prior) {
  return fit_similarity(
      common_points(pair,
                    [&](int part) { return std::count(parts.begin(), parts.end(), part) ? 1.0 : 0.05; }),
      prior);
}

}  // namespace partwise
