#include "segmentation/transfer_labels.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "error.h"
#include "geometry/normals.h"
#include "geometry/surface_index.h"
#include "segmentation/crease_field.h"
#include "segmentation/label_repair.h"
#include "segmentation/surface_places.h"

namespace partwise {
namespace {

constexpr int kLeastRows = 2, kMostRows = 8;  // of samples in a facet
constexpr int kBlurs = 2;

/// Centroids of the rows^2 equal triangles that a facet is cut into.
Points facet_samples(const TriMesh& mesh, int f, int rows) {
  const auto& [a, b, c] = mesh.facet(f);
  const Vec3 u = (mesh.point(b) - mesh.point(a)) / rows, v = (mesh.point(c) - mesh.point(a)) / rows;
  Points samples;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; i + j < rows; ++j) {
      samples.push_back(mesh.point(a) + (i + 1 / 3.0) * u + (j + 1 / 3.0) * v);
      if (i + j + 1 < rows) samples.push_back(mesh.point(a) + (i + 2 / 3.0) * u + (j + 2 / 3.0) * v);
    }
  }
  return samples;
}

/// The labelled mesh, its bounding box stretched onto that of `mesh`.
TriMesh on_box_of(const TriMesh& mesh, const TriMesh& labelled) {
  auto box = [](const TriMesh& m) {
    Eigen::AlignedBox3d result;
    for (const Vec3& p : m.points()) result.extend(p);
    return result;
  };
  const Eigen::AlignedBox3d from = box(labelled), to = box(mesh);
  Vec3 scale = Vec3::Ones();
  for (int axis = 0; axis < 3; ++axis) {
    if (from.sizes()[axis] > 0) scale[axis] = to.sizes()[axis] / from.sizes()[axis];
  }
  Points points = labelled.points();
  for (Vec3& p : points) p = to.center() + scale.cwiseProduct(p - from.center());
  return labelled.with_points(std::move(points));
}

/// Looks at few facets only: from far away every query is slow.
void require_closeness(const TriMesh& mesh, const TriMesh& labelled, double limit) {
  const SurfaceIndex index(labelled);
  const int step = 1 + mesh.facet_count() / 100;
  double mean = 0;
  int count = 0;
  for (int f = 0; f < mesh.facet_count(); f += step, ++count) {
    mean += index.closest(position(mesh, {f, Vec3::Constant(1 / 3.0)})).distance;
  }
  mean /= count * mesh.diagonal();
  if (mean <= limit) return;
  std::ostringstream text;
  text.precision(3);
  text << "the mesh lies " << 100 * mean
       << " % of its diagonal away from the mesh of the labels in the mean (at most " << 100 * limit
       << " %); labels pass between meshes of one shape in one place, or with one connectivity: check units "
          "and pose, or bring their bounding boxes together (--align-boxes)";
  throw InputError(text.str());
}

/// Means over each facet and its neighbours by area, so that there is a band to straighten boundaries in.
PartProbabilities blurred(const TriMesh& mesh, const PartProbabilities& shares) {
  const std::vector<double> areas = facet_areas(mesh.points(), mesh.facets());
  PartProbabilities result(shares.rows(), shares.cols());
  for (int f = 0; f < mesh.facet_count(); ++f) {
    double total = areas[f];
    result.row(f) = areas[f] * shares.row(f);
    for (const OpenMesh::FaceHandle g : mesh.half_edges().ff_range(OpenMesh::FaceHandle(f))) {
      total += areas[g.idx()];
      result.row(f) += areas[g.idx()] * shares.row(g.idx());
    }
    if (total > 0) result.row(f) /= total;
    if (!(total > 0)) result.row(f) = shares.row(f);
  }
  return result;
}

/// Straightens boundaries unless they run along edges of both meshes.
std::vector<int> straightened(const TriMesh& mesh, const Seeds& seeds, PartProbabilities shares,
                              const std::vector<double>& costs, const BandCutOptions& options) {
  if (shares.rowwise().maxCoeff().minCoeff() > 1 - 1e-9) return most_probable_parts(shares);
  for (int round = 0; round < kBlurs; ++round) shares = blurred(mesh, shares);
  return cut_band(mesh, seeds, shares, costs, options);
}

RepairedLabels labels_from_shares(const TriMesh& mesh, const std::vector<std::string>& names,
                                  const PartProbabilities& shares, const TransferOptions& options) {
  const Seeds none{std::vector<int>(mesh.vertex_count(), kUnseeded),
                   std::vector<int>(mesh.facet_count(), kUnseeded)};
  const std::vector<double> costs = boundary_costs(mesh, edge_concavity(mesh));
  return repair_labels(mesh, names, none, straightened(mesh, none, shares, costs, options.usual.band_cut),
                       costs);
}

double area_moved(const TriMesh& mesh, const PartProbabilities& shares, const std::vector<int>& labels) {
  const std::vector<double> areas = facet_areas(mesh.points(), mesh.facets());
  double moved = 0, total = 0;
  for (std::size_t f = 0; f < areas.size(); ++f) {
    moved += areas[f] * std::max(0.0, 1 - shares(static_cast<Eigen::Index>(f), labels[f]));
    total += areas[f];
  }
  return total > 0 ? moved / total : 0;
}

/// The model's markers and anchors as if sketched: by index when the mesh is `copied`, else by position.
Sketch landmarks_of(const SegmentedModel& model, const TriMesh& placed, bool copied) {
  Sketch sketch;
  for (const std::string& name : model.segmentation.names) sketch.parts.push_back({name, {}});
  for (const Marker& marker : model.markers) {
    const Place place = copied ? Place(marker.point) : Place(position(placed, marker.point));
    sketch.markers.push_back({marker.name, place});
  }
  for (const Anchor& anchor : model.anchors) {
    if (anchor.proposed) continue;  // proposed anew, if at all
    const Place place = copied ? Place(anchor.vertex) : Place(placed.point(anchor.vertex));
    const auto& names = model.segmentation.names;
    sketch.anchors.push_back({anchor.name, {names[anchor.part_a], names[anchor.part_b]}, place});
  }
  return sketch;
}

/// Adds landmarks; one of a name that is there already takes its place.
template <class Landmark>
void add(std::vector<Landmark>& landmarks, const std::vector<Landmark>& additions) {
  for (const Landmark& addition : additions) {
    const auto same = std::find_if(landmarks.begin(), landmarks.end(),
                                   [&](const Landmark& l) { return l.name == addition.name; });
    if (same == landmarks.end()) {
      landmarks.push_back(addition);
    } else {
      *same = addition;
    }
  }
}

void require_known_parts(const Segmentation& segmentation, const Sketch& additions) {
  for (const SketchedPart& part : additions.parts) {
    if (part_index(segmentation, part.name) >= 0) continue;
    throw InputError("part '" + part.name + "' is not among the parts of the labels; name only theirs");
  }
}

}  // namespace

LabelShares closest_labels(const TriMesh& mesh, const TriMesh& labelled, const std::vector<int>& labels,
                           int part_count) {
  const SurfaceIndex index(labelled);
  const std::vector<double> areas = facet_areas(mesh.points(), mesh.facets());
  const std::vector<double> labelled_areas = facet_areas(labelled.points(), labelled.facets());
  double mean_area = 0;
  for (const double area : labelled_areas) mean_area += area / labelled.facet_count();
  LabelShares result{PartProbabilities::Zero(mesh.facet_count(), part_count)};
  std::vector<double> mean(areas.size()), largest(areas.size());
  tbb::parallel_for(0, mesh.facet_count(), [&](int f) {
    const double rows = mean_area > 0 ? std::ceil(1 + std::sqrt(areas[f] / mean_area)) : kLeastRows;
    const Points samples =
        facet_samples(mesh, f, static_cast<int>(std::clamp<double>(rows, kLeastRows, kMostRows)));
    const double share = 1.0 / static_cast<double>(samples.size());
    for (const Vec3& sample : samples) {
      const SurfaceHit hit = index.closest(sample);
      result.shares(f, labels[hit.point.facet]) += share;
      mean[f] += share * hit.distance;
      largest[f] = std::max(largest[f], hit.distance);
    }
  });
  double total = 0;
  for (std::size_t f = 0; f < areas.size(); ++f) {
    result.mean_distance += areas[f] * mean[f];
    total += areas[f];
  }
  if (total > 0) result.mean_distance /= total;
  const auto farthest = std::max_element(largest.begin(), largest.end());
  result.largest_distance = *farthest;
  result.farthest_facet = static_cast<int>(farthest - largest.begin());
  return result;
}

TransferredSegmentation transfer_labels(const TriMesh& mesh, const SegmentedModel& from,
                                        const Sketch& additions, const TransferOptions& options) {
  require_known_parts(from.segmentation, additions);
  const bool copied = mesh.key() == from.mesh.key();
  const TriMesh placed = options.align_boxes && !copied ? on_box_of(mesh, from.mesh) : from.mesh;
  Sketch landmarks = landmarks_of(from, placed, copied);
  add(landmarks.markers, additions.markers);
  add(landmarks.anchors, additions.anchors);
  landmarks.mesh = additions.mesh;
  auto assembled = [&](RepairedLabels repaired) {
    return assemble_segmentation(mesh, std::move(repaired), landmarks, options.usual);
  };
  if (copied) {
    RepairedLabels labels;
    labels.labels = from.segmentation.labels;
    return {assembled(std::move(labels)), true, 0, 0, 0};
  }
  const std::vector<std::string>& names = from.segmentation.names;
  require_closeness(mesh, placed, options.usual.snap_limit);
  const LabelShares found =
      closest_labels(mesh, placed, from.segmentation.labels, static_cast<int>(names.size()));
  RepairedLabels repaired = labels_from_shares(mesh, names, found.shares, options);
  const double moved = area_moved(mesh, found.shares, repaired.labels);
  SegmentedMesh segmented = assembled(std::move(repaired));
  if (found.largest_distance > options.usual.snap_limit * mesh.diagonal()) {
    segmented.warnings.push_back("facet " + std::to_string(found.farthest_facet) +
                                 " lies farther from the mesh of the labels than --snap-limit; look at the "
                                 "part it got");
  }
  return {std::move(segmented), false, moved, found.mean_distance / mesh.diagonal(),
          found.largest_distance / mesh.diagonal()};
}

}  // namespace partwise
