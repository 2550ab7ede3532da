#include "mapping/part_crossing.h"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "geometry/orientation.h"
#include "mapping/energy_phases.h"
#include "mapping/hull_alignment.h"
#include "mapping/release_markers.h"
#include "mapping/untangle_on_hull.h"
#include "measure/hull_folds.h"

namespace partwise {
namespace {

constexpr double kPatientGrowth = 4;  ///< of the pulls, where the quicker ones leave folds
constexpr int kPatientIterations = 20;
constexpr double kCapWeight = 0.1;  ///< how much distortion counts in caps, which no one sees

Points about(const Points& points, const Vec3& centre) {
  Points result = points;
  for (Vec3& point : result) point -= centre;
  return result;
}

int local_facet(const Part& part, int model_facet) {
  const auto found = std::find(part.model_facet.begin(), part.model_facet.end(), model_facet);
  return static_cast<int>(found - part.model_facet.begin());
}

Vec3 at(const Facet& f, const Vec3& barycentric, const Points& points) {
  return barycentric[0] * points[f[0]] + barycentric[1] * points[f[1]] + barycentric[2] * points[f[2]];
}

}  // namespace

PartToHull::PartToHull(const ModelPair& pair, const HullMap& source, const HullMap& target,
                       const std::vector<BoundaryPlacement>& placements, int part,
                       const Eigen::Affine3d& alignment)
    : pair_(pair),
      source_(source.hulled.parts[pair.source_part[part]]),
      target_(target.hulled.parts[part]),
      part_(part),
      source_hull_(source.hulled.hulls[pair.source_part[part]]),
      target_hull_(target.hulled.hulls[part]),
      source_centre_(hull_centre(source_hull_)),
      target_centre_(hull_centre(target_hull_)),
      hull_(target_hull_, target_centre_),
      own_(about(source.images[pair.source_part[part]], source_centre_)),
      target_images_(about(target.images[part], target_centre_)) {
  for (int v = 0; v < source_.mesh.vertex_count(); ++v) {
    weights_.push_back(source_.is_cap_vertex(v) ? kCapWeight : 1);
  }
  pin_boundary(placements);
  pin_caps(placements);
  find_markers();
  align(alignment);
}

void PartToHull::pin_boundary(const std::vector<BoundaryPlacement>& placements) {
  for (const BoundaryPlacement& p : placements) {
    const int local = source_.local_vertex(p.source_vertex);
    if (local < 0) continue;
    const int a = target_.local_vertex(p.target_a), b = target_.local_vertex(p.target_b);
    const Vec3 goal = (1 - p.fraction) * target_images_[a] + p.fraction * target_images_[b];
    pins_.push_back({local, hull_.project(goal, 0).position});
  }
}

void PartToHull::pin_caps(const std::vector<BoundaryPlacement>& placements) {
  std::vector<int> target_loop(target_.mesh.vertex_count(), -1);
  for (std::size_t i = 0; i < target_.loops.size(); ++i) {
    for (const int v : target_.loops[i]) target_loop[v] = static_cast<int>(i);
  }
  for (std::size_t i = 0; i < source_.loops.size(); ++i) {
    const std::vector<int>& loop = source_.loops[i];
    const int model_vertex = source_.model_vertex[loop.front()];
    const auto place =
        std::lower_bound(placements.begin(), placements.end(), model_vertex,
                         [](const BoundaryPlacement& p, int v) { return p.source_vertex < v; });
    const int there = target_loop[target_.local_vertex(place->target_a)];
    const Vec3& goal = target_images_[target_.cap_vertices[there]];
    pins_.push_back({source_.cap_vertices[i], hull_.project(goal, 0).position});
    for (std::size_t j = 0; j < loop.size(); ++j) {
      kept_.push_back({loop[j], loop[(j + 1) % loop.size()]});
      kept_.push_back({loop[j], source_.cap_vertices[i]});
    }
  }
}

void PartToHull::find_markers() {
  for (const MarkerConstraint& marker : pair_.marker_constraints) {
    if (marker.part != part_) continue;
    const Facet& there = target_.mesh.facet(local_facet(target_, marker.target.facet));
    markers_.push_back({{local_facet(source_, marker.source.facet), marker.source.barycentric},
                        at(there, marker.target.barycentric, target_images_)});
  }
}

void PartToHull::align(const Eigen::Affine3d& alignment) {
  const Eigen::Matrix3d around = align_around(pair_, {part_}, alignment).linear();
  const Eigen::Matrix3d upright = around / std::cbrt(around.determinant());
  MatchedPoints matched;
  // Loops, caps and markers count alike, however finely a loop is cut.
  const auto caps = static_cast<double>(source_.cap_vertices.size());
  const double loop_weight = caps / std::max(1.0, static_cast<double>(pins_.size()) - caps);
  for (const Pin& pin : pins_) {
    matched.add(own_[pin.vertex], pin.goal, source_.is_cap_vertex(pin.vertex) ? 1 : loop_weight);
  }
  for (const LocalMarker& marker : markers_) {
    matched.add(marker_image(marker, own_), hull_.project(marker.goal, 0).position);
  }
  linear_ = align_to_hull(matched, about(source_hull_.points, source_centre_),
                          about(target_hull_.points, target_centre_), hull_, upright);
  int hint = 0;
  for (const Vec3& point : own_) {
    const StarHull::Place place = hull_.project(linear_ * point, hint);
    start_.push_back(place.position);
    hint = place.facet;
  }
}

Vec3 PartToHull::marker_image(const LocalMarker& marker, const Points& images) const {
  return at(source_.mesh.facet(marker.source.facet), marker.source.barycentric, images);
}

/// A marker inside a facet is held by the corner nearest to it that is still free, at a distance that the
/// alignment foretells.
std::vector<PartToHull::MarkerPin> PartToHull::marker_pins() const {
  std::set<int> taken;
  for (const Pin& pin : pins_) taken.insert(pin.vertex);
  std::vector<MarkerPin> pins;
  for (std::size_t m = 0; m < markers_.size(); ++m) {
    const LocalMarker& marker = markers_[m];
    const Facet& f = source_.mesh.facet(marker.source.facet);
    std::array<int, 3> corners{0, 1, 2};
    std::stable_sort(corners.begin(), corners.end(), [&](int i, int j) {
      return marker.source.barycentric[i] > marker.source.barycentric[j];
    });
    const auto corner = std::find_if(corners.begin(), corners.end(), [&](int i) {
      return marker.source.barycentric[i] > 0 && !taken.contains(f[i]);
    });
    if (corner == corners.end()) continue;
    const int v = f[*corner];
    taken.insert(v);
    const Vec3 offset = linear_ * (own_[v] - marker_image(marker, own_));
    pins.push_back(
        {{v, hull_.project(marker.goal + offset, 0).position}, m, marker.source.barycentric[*corner]});
  }
  return pins;
}

/// The aligned start is a similar copy of Q^s that meets its goals: no relaxation can improve it.
bool PartToHull::is_in_place(const std::vector<Pin>& markers) const {
  constexpr double kRounding = 1e-10;
  const double near = kRounding * bounding_box_diagonal(target_hull_.points);
  const Vec3 stretch = Eigen::JacobiSVD<Eigen::Matrix3d>(linear_).singularValues();
  if (stretch[0] - stretch[2] > kRounding * stretch[0]) return false;
  for (std::size_t v = 0; v < own_.size(); ++v) {
    if ((start_[v] - linear_ * own_[v]).norm() > near) return false;
  }
  auto met = [&](const Pin& pin) { return (start_[pin.vertex] - pin.goal).norm() <= near; };
  return std::all_of(pins_.begin(), pins_.end(), met) && std::all_of(markers.begin(), markers.end(), met);
}

/// [Wu11] Eq. (7-14) on the target's hull: G are the markers, the centres of caps and, weakly, where the
/// aligned start has the vertices of the source's hull. The part is brought to the target's size, so that
/// units do not matter.
Points PartToHull::energy_start(const std::vector<Pin>& markers, const EnergyMapOptions& options) const {
  constexpr double kHullVertexWeight = 0.1;
  std::vector<VertexTarget> global, boundary;
  std::vector<bool> known(start_.size(), false);
  for (const Pin& pin : pins_) {
    (source_.is_cap_vertex(pin.vertex) ? global : boundary).push_back({pin.vertex, pin.goal});
    known[pin.vertex] = true;
  }
  for (const Pin& pin : markers) {
    global.push_back({pin.vertex, pin.goal});
    known[pin.vertex] = true;
  }
  for (const int v : source_hull_.part_vertex) {
    if (!known[v]) global.push_back({v, start_[v], kHullVertexWeight});
  }
  ConvexHull hull = target_hull_;
  hull.points = about(target_hull_.points, target_centre_);
  Points points = source_.mesh.points();
  const double scale = bounding_box_diagonal(hull.points) / source_.mesh.diagonal();
  for (Vec3& point : points) point *= scale;
  const TriMesh part = source_.mesh.with_points(std::move(points));
  Points result = minimise_energy(part, laplacian_weights(part, options.laplacian), HullTarget(hull), global,
                                  boundary, options);
  for (Vec3& point : result) {
    if (point.isZero(0)) point = Vec3::UnitX();  // the centre has no direction; any place will do
    point = hull_.project(point, 0).position;
  }
  return result;
}

PinnedMap PartToHull::pinned(const std::vector<Pin>& markers, const std::vector<Pin>& drawn,
                             const HullToHullOptions& options) const {
  std::vector<Pin> all = pins_;
  all.insert(all.end(), markers.begin(), markers.end());
  const Facets& facets = source_.mesh.facets();
  if (options.method == CrossMethod::pull && hull_folds(start_, facets, Vec3::Zero()).count() == 0) {
    PinOptions pulling;
    pulling.drawn = drawn;
    PinnedMap map = pin_on_hull(source_.mesh, weights_, hull_, start_, all, kept_, pulling);
    if (free_folds(map.images) == 0) return map;
    pulling.pull_growth = kPatientGrowth;
    pulling.iterations_per_pull = kPatientIterations;
    PinnedMap patient = pin_on_hull(source_.mesh, weights_, hull_, start_, all, kept_, pulling);
    return free_folds(patient.images) < free_folds(map.images) ? patient : map;
  }
  PinnedMap result;
  result.images = energy_start(markers, options.energy);
  std::vector<bool> fixed(start_.size(), false);
  for (const Pin& pin : all) {
    fixed[pin.vertex] = true;
    result.images[pin.vertex] = pin.goal;
  }
  result.images = untangle_on_hull(source_.mesh, hull_, result.images, fixed).images;
  for (const Pin& pin : all) result.images[pin.vertex] = pin.goal;
  result.folds = hull_folds(result.images, facets, Vec3::Zero()).count();
  return result;
}

double PartToHull::strain() const {
  if (hull_folds(start_, source_.mesh.facets(), Vec3::Zero()).count() > 0) {
    return std::numeric_limits<double>::infinity();
  }
  HullRelaxationOptions drawing;
  drawing.pulls = pins_;
  for (const MarkerPin& marker : marker_pins()) drawing.pulls.push_back(marker.pin);
  drawing.pull_weight = 1e2;
  drawing.rounding = {0.2};
  drawing.most_iterations = 15;  // at 8, a tail of cat -> lion is not settled enough to tell its turns apart
  const Points images = relax_on_hull(source_.mesh, weights_, hull_, start_, {}, drawing).images;
  double left = 0;
  for (const Pin& pull : drawing.pulls) left += (images[pull.vertex] - pull.goal).squaredNorm();
  return hull_distortion(source_.mesh, weights_, hull_, images) - 1 +
         drawing.pull_weight * left / (4 * hull_.area());
}

/// Folded facets that have a corner off the boundary: the others are as their boundary makes them.
int PartToHull::free_folds(const Points& images) const {
  std::vector<bool> on_boundary(images.size(), false);
  for (const Pin& pin : pins_) on_boundary[pin.vertex] = true;
  const std::vector<int> folded = hull_folds(images, source_.mesh.facets(), Vec3::Zero()).folded;
  return static_cast<int>(std::count_if(folded.begin(), folded.end(), [&](int f) {
    const Facet& facet = source_.mesh.facet(f);
    return !std::all_of(facet.begin(), facet.end(), [&](int v) { return on_boundary[v]; });
  }));
}

/// Brings a marker inside a facet to its goal by moving the corner that holds it, the others being as they
/// are; not where that would fold a facet.
void PartToHull::place_exactly(const MarkerPin& pin, Points& images) const {
  constexpr int kSteps = 40;
  const LocalMarker& marker = markers_[pin.marker];
  const Vec3 goal = hull_.project(marker.goal, 0).position;
  const int v = pin.pin.vertex;
  const Vec3 before = images[v];
  for (int step = 0; step < kSteps; ++step) {
    const Vec3 image = hull_.project(marker_image(marker, images), 0).position;
    if (image == goal) break;
    images[v] = hull_.project(images[v] + (goal - image) / pin.weight, 0).position;
  }
  for (const auto f : source_.mesh.half_edges().vf_range(OpenMesh::VertexHandle(v))) {
    const auto& [a, b, c] = source_.mesh.facet(f.idx());
    if (orientation_sign(Vec3::Zero(), images[a], images[b], images[c]) > 0) continue;
    images[v] = before;
    return;
  }
}

MarkedMap PartToHull::marked(const std::vector<Pin>& markers, const HullToHullOptions& options) const {
  auto map_with = [&](const std::vector<Pin>& held, const std::vector<Pin>& drawn) {
    if (drawn.empty() && is_in_place(held)) {
      PinnedMap map{start_, 0, 1, 0};
      for (const Pin& pin : pins_) map.images[pin.vertex] = pin.goal;
      for (const Pin& pin : held) map.images[pin.vertex] = pin.goal;
      return map;
    }
    return pinned(held, drawn, options);
  };
  return map_with_markers(markers, map_with, [&](const PinnedMap& map) { return free_folds(map.images); });
}

PartToHull::Result PartToHull::run(const HullToHullOptions& options) const {
  Result result;
  PartCrossing& crossing = result.crossing;
  const Facets& facets = source_.mesh.facets();
  const std::vector<MarkerPin> marker_places = marker_pins();
  std::vector<Pin> markers;
  for (const MarkerPin& place : marker_places) markers.push_back(place.pin);
  Points placed = start_;
  for (const Pin& pin : pins_) placed[pin.vertex] = pin.goal;
  for (const Pin& pin : markers) placed[pin.vertex] = pin.goal;
  crossing.source_folds = hull_folds(own_, facets, Vec3::Zero()).count();
  crossing.folds_before = hull_folds(placed, facets, Vec3::Zero()).count();

  MarkedMap marked_map = marked(markers, options);
  Points& images = marked_map.map.images;
  result.marker_held.assign(markers_.size(), false);
  for (std::size_t i = 0; i < marker_places.size(); ++i) {
    if (!marked_map.held[i]) continue;
    result.marker_held[marker_places[i].marker] = true;
    place_exactly(marker_places[i], images);
  }
  crossing.name = pair_.target.segmentation.names[part_];
  for (const LocalMarker& marker : markers_) {
    const Vec3 image = hull_.project(marker_image(marker, images), 0).position;
    result.marker_distances.push_back((image - hull_.project(marker.goal, 0).position).norm());
  }
  for (const Vec3& image : images) result.images.push_back(target_centre_ + image);
  const HullFolds folds = hull_folds(result.images, facets, target_centre_);
  crossing.folds = folds.count();
  crossing.locked_folds = crossing.folds - free_folds(images);
  crossing.degree = folds.degree;
  crossing.euler_characteristic = source_.mesh.euler_characteristic();
  crossing.one_to_one = crossing.euler_characteristic == 2 && folds.one_to_one();
  crossing.distortion = crossing.folds == crossing.locked_folds ? marked_map.map.distortion : 0;
  return result;
}

}  // namespace partwise
