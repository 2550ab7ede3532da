#include "remeshing/reconstruct.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "error.h"
#include "geometry/convex_hull.h"
#include "mesh/surface_walk.h"
#include "remeshing/domain_average.h"
#include "remeshing/locate.h"

namespace partwise {
namespace {

using Candidates = std::vector<SurfacePoint>;

/// The placement as a point of a facet beside its edge.
SurfacePoint on_target(const TriMesh& target, const BoundaryPlacement& place) {
  const HalfEdges& half_edges = target.half_edges();
  const bool known = std::min(place.target_a, place.target_b) >= 0 &&
                     std::max(place.target_a, place.target_b) < target.vertex_count();
  const OpenMesh::VertexHandle a(place.target_a), b(place.target_b);
  auto edge = HalfEdges::InvalidHalfedgeHandle;
  if (known) edge = a == b ? half_edges.halfedge_handle(a) : half_edges.find_halfedge(a, b);
  if (!edge.is_valid() || !(place.fraction >= 0 && place.fraction <= 1)) {
    throw InputError("source vertex " + std::to_string(place.source_vertex) + " is placed at " +
                     std::to_string(place.fraction) + " between target vertices " +
                     std::to_string(place.target_a) + " and " + std::to_string(place.target_b) +
                     ", which is no place on an edge; run hull-to-hull on the same target");
  }
  const auto here = half_edges.face_handle(edge);
  const auto beside = half_edges.face_handle(half_edges.opposite_halfedge_handle(edge));
  const int facet = here.is_valid() ? here.idx() : beside.idx();
  SurfacePoint point{facet, Vec3::Zero()};
  for (int i = 0; i < 3; ++i) {
    if (target.facet(facet)[i] == place.target_a) point.barycentric[i] += 1 - place.fraction;
    if (target.facet(facet)[i] == place.target_b) point.barycentric[i] += place.fraction;
  }
  return point;
}

/// Places all source vertices; the state of one call of `reconstruct`.
class Placement {
 public:
  Placement(const CrossMap& map, const ReconstructOptions& options)
      : map_(map),
        options_(options),
        source_(map.source.mesh),
        target_(map.target.hulled.model.mesh),
        walker_(target_),
        candidates_(source_.vertex_count()),
        is_placed_(source_.vertex_count(), false) {
    for (const BoundaryPlacement& place : map.boundary) {
      candidates_.at(place.source_vertex) = {on_target(target_, place)};
      is_placed_[place.source_vertex] = true;
    }
    for (std::size_t k = 0; k < map.source_parts.size(); ++k) locate_part(k);
    choose();
    hit_markers();
  }

  std::vector<SurfacePoint> images() const {
    std::vector<SurfacePoint> result;
    for (const Candidates& c : candidates_) result.push_back(c.front());
    return result;
  }
  const ReconstructMetrics& metrics() const { return metrics_; }

 private:
  void locate_part(std::size_t k) {
    const Part &source_part = map_.source_parts[k], &target_part = map_.target.hulled.parts[k];
    const ConvexHull& hull = map_.target.hulled.hulls[k];
    const Points& images = map_.target.images[k];
    const DomainLocator locator(target_part, images, hull_centre(hull));
    const DomainAverage average(target_part, images, hull, options_.coordinates, options_.radius);
    for (int v = 0; v < source_part.mesh.vertex_count(); ++v) {
      if (source_part.is_cap_vertex(v)) continue;
      Candidates& candidates = candidates_[source_part.model_vertex[v]];
      const Vec3& image = map_.images[k][v];
      if (is_placed_[source_part.model_vertex[v]]) {
        note_gap(position(target_, candidates.front()), locator, image);
        continue;
      }
      const Candidates found = locator.locate(image);
      for (const SurfacePoint& local : found) candidates.push_back(locator.on_model(local));
      if (target_part.is_cap_facet(found.front().facet)) ++metrics_.on_caps;
      if (options_.coordinates == Coordinates::facet) continue;
      for (std::size_t i = 0; i < found.size(); ++i) project(candidates[i], average.at(image, found[i]));
    }
  }

  /// Notes how far the part's own map puts a boundary vertex from its place.
  void note_gap(const Vec3& place, const DomainLocator& locator, const Vec3& image) {
    double gap = std::numeric_limits<double>::infinity();
    for (const SurfacePoint& local : locator.locate(image)) {
      gap = std::min(gap, (position(target_, locator.on_model(local)) - place).norm());
    }
    metrics_.boundary_gap_max = std::max(metrics_.boundary_gap_max, gap / target_.diagonal());
  }

  void project(SurfacePoint& candidate, const Vec3& average) {
    candidate = walker_.towards(candidate, average);
    const double distance = (position(target_, candidate) - average).norm() / target_.diagonal();
    metrics_.largest_projection = std::max(metrics_.largest_projection, distance);
  }

  /// Decides between several candidates, once neighbours are decided. Candidates that are one point of the
  /// target, seen from both sides of an edge, are no choice.
  void choose() {
    const double same = 1e-9 * target_.diagonal();
    std::vector<int> open;
    for (int v = 0; v < source_.vertex_count(); ++v) {
      Candidates& c = candidates_[v];
      if (c.empty()) throw InputError("source vertex " + std::to_string(v) + " belongs to no part");
      const Vec3 first = position(target_, c.front());
      const bool is_one = std::all_of(c.begin(), c.end(), [&](const SurfacePoint& p) {
        return (position(target_, p) - first).norm() <= same;
      });
      if (is_one) {
        c.resize(1);
      } else {
        open.push_back(v);
      }
    }
    metrics_.ambiguous = static_cast<int>(open.size());
    while (!open.empty()) {
      std::vector<int> left;
      for (const int v : open) {
        if (!choose_nearest(v)) left.push_back(v);
      }
      if (left.size() == open.size()) candidates_[left.front()].resize(1);  // nothing decided around it
      open = std::move(left);
    }
  }

  bool choose_nearest(int vertex) {
    Candidates& c = candidates_[vertex];
    if (c.size() == 1) return true;
    Points neighbours;
    for (const auto n : source_.half_edges().vv_range(OpenMesh::VertexHandle(vertex))) {
      const Candidates& others = candidates_[n.idx()];
      if (others.size() == 1) neighbours.push_back(position(target_, others.front()));
    }
    if (neighbours.empty()) return false;
    double nearest = std::numeric_limits<double>::infinity();
    SurfacePoint best;
    for (const SurfacePoint& candidate : c) {
      double sum = 0;
      for (const Vec3& p : neighbours) sum += (position(target_, candidate) - p).squaredNorm();
      if (sum >= nearest) continue;
      nearest = sum;
      best = candidate;
    }
    c = {best};
    return true;
  }

  /// A marker at a source vertex that came out at its goal within rounding is put exactly there.
  void hit_markers() {
    for (const MarkerPair& marker : map_.markers) {
      const std::optional<int> v = vertex_at(source_, marker.source);
      if (!v) continue;
      SurfacePoint& image = candidates_[*v].front();
      const double distance = (position(target_, image) - position(target_, marker.target)).norm();
      if (distance <= 1e-6 * target_.diagonal()) image = marker.target;
    }
  }

  const CrossMap& map_;
  const ReconstructOptions& options_;
  const TriMesh &source_, &target_;
  SurfaceWalker walker_;
  std::vector<Candidates> candidates_;  ///< per source vertex; one each at the end
  std::vector<bool> is_placed_;         ///< per source vertex: by CrossMap::boundary
  ReconstructMetrics metrics_;
};

/// Facet labels of the source in the target's order of parts.
std::vector<int> labels_in_target_order(const CrossMap& map) {
  std::vector<int> target_part(map.source_parts.size());
  for (std::size_t k = 0; k < map.source_parts.size(); ++k) {
    target_part[map.source_parts[k].index] = static_cast<int>(k);
  }
  std::vector<int> labels = map.source.segmentation.labels;
  for (int& label : labels) label = target_part[label];
  return labels;
}

}  // namespace

Reconstruction reconstruct(const CrossMap& map, const ReconstructOptions& options) {
  if (!(options.radius > 0)) throw InputError("the radius of the averaging must be positive");
  const Placement placement(map, options);
  const SegmentedModel& target = map.target.hulled.model;
  SurfaceMap images(map.source.mesh, target.mesh, placement.images());
  Points points = images.positions(target.mesh);
  CompatibleMesh mesh{map.source.mesh,
                      target.mesh,
                      std::move(points),
                      std::move(images),
                      labels_in_target_order(map),
                      target.segmentation.labels,
                      target.segmentation.names,
                      map.markers,
                      {}};
  if (!options.one_to_one) return {std::move(mesh), placement.metrics()};
  OneToOneMap whole = make_one_to_one(mesh, charts_of_parts(map.target));
  ReconstructMetrics metrics = placement.metrics();
  metrics.charts = std::move(whole.charts);
  metrics.moved_vertices = whole.moved_vertices;
  metrics.curves_held = whole.curves_held;
  metrics.placed_markers = std::move(whole.placed_markers);
  return {std::move(whole.mesh), std::move(metrics)};
}

}  // namespace partwise
