#include "remeshing/critical_fit.h"

#include <algorithm>

#include "energy/critical_constraint.h"
#include "energy/laplacian.h"
#include "geometry/surface_index.h"
#include "solve/least_squares.h"

namespace partwise {
namespace {

/// Whether a walk over the target leads from the vertex to the point: both are on one sheet.
bool reaches(const MeshOnSurface& mesh, int vertex, const Vec3& goal) {
  const SurfacePoint end = mesh.walker().towards(mesh.image(vertex), goal);
  return (position(mesh.target(), end) - goal).norm() <= 1e-9 * mesh.target().diagonal();
}

bool has_met(const MeshOnSurface& mesh, const CriticalPair& pair) {
  const double distance = (mesh.points()[pair.vertex] - mesh.target().point(pair.target_vertex)).norm();
  return distance <= 1e-9 * mesh.target().diagonal();
}

/// What Eq. (17) asks of the displacements: those of paired vertices, and none of pinned ones.
std::vector<VertexTarget> wanted_steps(const MeshOnSurface& mesh, const std::vector<CriticalPair>& pairs) {
  constexpr double firmly = 1e4;
  std::vector<VertexTarget> wanted;
  for (int v = 0; v < mesh.source().vertex_count(); ++v) {
    if (mesh.is_pinned(v)) wanted.push_back({v, Vec3::Zero(), firmly});
  }
  for (const CriticalPair& pair : pairs) {
    if (mesh.is_pinned(pair.vertex)) continue;
    const Vec3 step = mesh.target().point(pair.target_vertex) - mesh.points()[pair.vertex];
    wanted.push_back({pair.vertex, step});
  }
  return wanted;
}

}  // namespace

std::vector<CriticalPair> pair_critical_points(const MeshOnSurface& mesh,
                                               const std::vector<CriticalPoint>& critical) {
  const SurfaceIndex surface(mesh.points(), mesh.source().facets());
  std::vector<bool> taken(mesh.points().size(), false);
  std::vector<CriticalPair> pairs;
  for (const CriticalPoint& point : critical) {
    const Vec3& goal = mesh.target().point(point.vertex);
    Facet corners = mesh.source().facet(surface.closest(goal).point.facet);
    std::sort(corners.begin(), corners.end(), [&](int a, int b) {
      return (mesh.points()[a] - goal).squaredNorm() < (mesh.points()[b] - goal).squaredNorm();
    });
    for (const int v : corners) {
      if (taken[v] || mesh.is_pinned(v) || !reaches(mesh, v, goal)) continue;
      taken[v] = true;
      pairs.push_back({v, point.vertex});
      break;
    }
  }
  return pairs;
}

std::vector<CriticalPair> fit_critical_points(MeshOnSurface& mesh, const std::vector<CriticalPoint>& critical,
                                              const CriticalFitOptions& options) {
  std::vector<CriticalPair> pairs = pair_critical_points(mesh, critical);
  const EnergyTerm laplacian =
      laplacian_term(mean_value_weights(mesh.source().points(), mesh.source().facets()));
  const int count = mesh.source().vertex_count();
  LeastSquares system(count);
  std::size_t met = 0;
  auto pin_met = [&] {
    for (const CriticalPair& pair : pairs) {
      if (mesh.is_pinned(pair.vertex)) continue;
      mesh.move_towards(pair.vertex, mesh.target().point(pair.target_vertex), 0);
      if (!has_met(mesh, pair)) continue;
      mesh.pin(pair.vertex);
      ++met;
    }
  };
  for (int i = 0; i < options.iterations && met < pairs.size(); ++i) {
    system.clear();
    system.add(1, laplacian);
    system.add(options.weight, critical_constraint_term(count, wanted_steps(mesh, pairs)));
    const Points steps = system.minimise();
    for (int v = 0; v < count; ++v) mesh.move_towards(v, mesh.points()[v] + steps[v]);
    pin_met();
  }
  for (const CriticalPair& pair : pairs) mesh.unpin(pair.vertex);
  std::erase_if(pairs, [&](const CriticalPair& pair) { return !has_met(mesh, pair); });
  return pairs;
}

std::vector<CriticalPair> meet_critical_points(MeshOnSurface& mesh, std::vector<CriticalPair> pairs,
                                               double least_quality) {
  std::erase_if(pairs, [&](const CriticalPair& pair) {
    if (!has_met(mesh, pair)) {
      const Vec3& goal = mesh.target().point(pair.target_vertex);
      mesh.move_to(pair.vertex, mesh.walker().towards(mesh.image(pair.vertex), goal), least_quality);
    }
    return !has_met(mesh, pair);
  });
  return pairs;
}

}  // namespace partwise
