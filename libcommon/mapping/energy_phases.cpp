#include "mapping/energy_phases.h"

#include "energy/boundary_correspondence.h"
#include "energy/convex_approximation.h"
#include "energy/global_constraint.h"
#include "energy/laplacian.h"
#include "geometry/normals.h"
#include "solve/least_squares.h"

namespace partwise {
namespace {

/// Normals of the shape as it is now; where one turns by more than 90 degrees at once, only half of the way:
/// a facet that turns over for a moment must not send its vertices to the other side of the hull.
void follow_normals(Points& normals, const Points& points, const Facets& facets) {
  const Points current = vertex_normals(points, facets);
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const Vec3 halfway = normals[v] + current[v];
    if (current[v].dot(normals[v]) >= 0) {
      normals[v] = current[v];
    } else if (halfway.norm() > 0.1) {
      normals[v] = halfway.normalized();
    }
  }
}

/// Vertices without a constraint.
std::vector<int> free_vertices(int count, const std::vector<VertexTarget>& global,
                               const std::vector<VertexTarget>& boundary) {
  std::vector<bool> constrained(count, false);
  for (const VertexTarget& constraint : global) constrained[constraint.vertex] = true;
  for (const VertexTarget& constraint : boundary) constrained[constraint.vertex] = true;
  std::vector<int> free;
  for (int v = 0; v < count; ++v) {
    if (!constrained[v]) free.push_back(v);
  }
  return free;
}

std::vector<HullApproach> closest_on_hull(const std::vector<int>& vertices, const Points& points,
                                          const SurfaceIndex& hull) {
  std::vector<HullApproach> approaches;
  for (const int v : vertices) {
    const SurfaceHit hit = hull.closest(points[v]);
    approaches.push_back({v, hit.position, hit.distance});
  }
  return approaches;
}

}  // namespace

HullTarget::HullTarget(const ConvexHull& hull)
    : index(hull.points, hull.facets), normals(facet_normals(hull.points, hull.facets)) {}

VertexWeights laplacian_weights(const TriMesh& mesh, LaplacianKind kind) {
  return kind == LaplacianKind::mean_value ? mean_value_weights(mesh.points(), mesh.facets())
                                           : uniform_weights(mesh.vertex_count(), mesh.facets());
}

Points minimise_energy(const TriMesh& mesh, const VertexWeights& weights, const HullTarget& hull,
                       const std::vector<VertexTarget>& global, const std::vector<VertexTarget>& boundary,
                       const EnergyMapOptions& options) {
  const int n = mesh.vertex_count();
  const EnergyTerm smoothness = laplacian_term(weights);
  const EnergyTerm known_places = global_constraint_term(n, global);
  const EnergyTerm boundary_places = boundary_correspondence_term(n, boundary);
  const std::vector<double> areas = ring_areas(mesh.points(), mesh.facets());
  const std::vector<int> free = free_vertices(n, global, boundary);

  LeastSquares system(n);
  system.add(1, smoothness);
  system.add(options.global_weight, known_places);
  system.add(1, boundary_places);
  Points points = system.minimise();
  Points normals = vertex_normals(points, mesh.facets());
  for (int step = 0; step < options.steps; ++step) {
    const double along = options.steps > 1 ? static_cast<double>(step) / (options.steps - 1) : 1;
    const double convex_weight =
        options.first_convex_weight + along * (options.last_convex_weight - options.first_convex_weight);
    follow_normals(normals, points, mesh.facets());
    const auto approaches = options.fitting == HullFitting::normal
                                ? approach_hull(free, points, normals, hull.index, hull.normals)
                                : closest_on_hull(free, points, hull.index);
    system.clear();
    system.add(1, smoothness);                                                                 // Eq. (7-9)
    system.add(options.global_weight, known_places);                                           // Eq. (12)
    system.add(convex_weight, convex_approximation_term(approaches, areas, mesh.diagonal()));  // Eq. (10-11)
    system.add(1, boundary_places);                                                            // Eq. (14)
    points = system.minimise();
  }
  return points;
}

}  // namespace partwise
