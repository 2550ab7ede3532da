#include "mapping/map_by_energy.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "energy/convex_approximation.h"
#include "geometry/normals.h"
#include "geometry/surface_index.h"
#include "mapping/energy_phases.h"
#include "mapping/repair_folds.h"
#include "mapping/star_hull.h"
#include "mapping/untangle_on_hull.h"
#include "measure/hull_folds.h"

namespace partwise {
namespace {

/// A hollow less deep than this, over the part's diagonal, has no concave extreme point.
constexpr double kLeastHollow = 0.02;

/// Per vertex: the largest of its own value and its neighbours'.
std::vector<double> largest_around(const VertexWeights& neighbours, const std::vector<double>& values) {
  std::vector<double> largest = values;
  for (int i = 0; i < neighbours.rows(); ++i) {
    for (VertexWeights::InnerIterator j(neighbours, i); j; ++j)
      largest[i] = std::max(largest[i], values[j.col()]);
  }
  return largest;
}

/// Whether nothing of the part stands between a vertex and its place on the hull.
bool sees_hull(const HullApproach& approach, const TriMesh& mesh, const SurfaceIndex& surface) {
  const Vec3& from = mesh.point(approach.vertex);
  const double ownself = 1e-9 * mesh.diagonal();  // the ray starts on the surface
  const std::vector<SurfaceHit> hits = surface.all_hits(from, approach.target - from);
  return std::none_of(hits.begin(), hits.end(), [&](const SurfaceHit& hit) {
    return hit.distance > ownself && hit.distance < approach.distance - ownself;
  });
}

/// Vertices that lie farther from the hull, along their normals, than all others within two edges, with their
/// places on the hull: the deepest points of hollows. Hollows that do not see the hull along that normal (a
/// mouth, an armpit) have no meaningful place there.
std::vector<VertexTarget> concave_extreme_points(const TriMesh& mesh, const VertexWeights& neighbours,
                                                 const HullTarget& hull, const std::vector<int>& candidates) {
  const Points normals = vertex_normals(mesh.points(), mesh.facets());
  const std::vector<HullApproach> approaches =
      approach_hull(candidates, mesh.points(), normals, hull.index, hull.normals);
  std::vector<double> depth(mesh.vertex_count(), 0.0);
  for (const HullApproach& approach : approaches) depth[approach.vertex] = approach.distance;
  const std::vector<double> largest = largest_around(neighbours, largest_around(neighbours, depth));
  const SurfaceIndex surface(mesh);
  const double least = kLeastHollow * mesh.diagonal();
  std::vector<VertexTarget> extreme;
  for (const HullApproach& approach : approaches) {
    const bool is_deepest = approach.distance > least && approach.distance >= largest[approach.vertex];
    if (is_deepest && sees_hull(approach, mesh, surface))
      extreme.push_back({approach.vertex, approach.target});
  }
  return extreme;
}

/// G of Eq. (12): where it is known from the start where a vertex belongs.
std::vector<VertexTarget> global_constraints(const Part& part, const ConvexHull& hull,
                                             const VertexWeights& neighbours, const HullTarget& target) {
  const TriMesh& mesh = part.mesh;
  std::vector<bool> constrained(mesh.vertex_count(), false);
  for (const int v : part.cap_vertices) constrained[v] = true;  // never: they move freely
  std::vector<VertexTarget> constraints;
  const auto constrain = [&](int vertex, const Vec3& place) {
    if (constrained[vertex]) return;
    constrained[vertex] = true;
    constraints.push_back({vertex, place});
  };
  for (const int v : hull.part_vertex) constrain(v, mesh.point(v));
  for (const std::vector<int>& loop : part.loops) {
    for (const int v : loop) constrain(v, target.index.closest(mesh.point(v)).position);
  }
  std::vector<int> others;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (!constrained[v]) others.push_back(v);
  }
  for (const VertexTarget& extreme : concave_extreme_points(mesh, neighbours, target, others))
    constrain(extreme.vertex, extreme.target);
  return constraints;
}

/// The sum of Eq. (13) with w_c growing step by step.
Points minimise_part_energy(const Part& part, const ConvexHull& hull, const HullTarget& target,
                            const EnergyMapOptions& options) {
  const TriMesh& mesh = part.mesh;
  const VertexWeights weights = laplacian_weights(mesh, options.laplacian);
  return minimise_energy(mesh, weights, target, global_constraints(part, hull, weights, target), {}, options);
}

/// Positions relative to the hull's centre, one per vertex, on the hull.
struct Projected {
  Points images;
  HullFolds folds;
};

Projected project(const Points& directions, const Facets& facets, const StarHull& hull) {
  Projected result;
  StarHull::Place place;
  for (const Vec3& direction : directions) {
    place = hull.project(direction, place.facet);
    result.images.push_back(place.position);
  }
  result.folds = hull_folds(result.images, facets, Vec3::Zero());
  return result;
}

/// First by means of neighbours, then by untangling the rest; the latter can wind the map around the hull
/// once more, in which case its result is worse than the folds it undoes.
Projected repaired(const Part& part, const Projected& map, const StarHull& hull) {
  if (map.folds.folded.empty()) return map;
  const Facets& facets = part.mesh.facets();
  const VertexWeights weights = mean_value_weights(part.mesh.points(), facets);
  Projected local = project(repair_folds(facets, weights, map.images), facets, hull);
  if (local.folds.folded.empty()) return local;
  const std::vector<bool> none_fixed(map.images.size(), false);
  Projected untangled =
      project(untangle_on_hull(part.mesh, hull, local.images, none_fixed).images, facets, hull);
  const auto surplus = [](const Projected& p) { return std::abs(p.folds.degree - 1); };
  const bool better =
      untangled.folds.count() < local.folds.count() && surplus(untangled) < surplus(local) + 0.5;
  return better ? untangled : local;
}

}  // namespace

EnergyMap map_by_energy(const Part& part, const ConvexHull& hull, const EnergyMapOptions& options) {
  const HullTarget target(hull);
  const Vec3 centre = hull_centre(hull);
  Points points = minimise_part_energy(part, hull, target, options);
  EnergyMap result;
  for (Vec3& p : points) {
    result.off_hull = std::max(result.off_hull, target.index.closest(p).distance);
    p -= centre;
    if (p.isZero(0)) p = Vec3::UnitX();  // the centre itself has no direction; any place will do
  }
  const StarHull star(hull, centre);
  const Projected before = project(points, part.mesh.facets(), star);
  Projected after = repaired(part, before, star);
  result.folds_before = before.folds.count();
  result.folds_after = after.folds.count();
  for (Vec3& image : after.images) image += centre;
  result.images = std::move(after.images);
  return result;
}

}  // namespace partwise
