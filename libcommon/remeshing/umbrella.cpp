#include "remeshing/umbrella.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "energy/critical_constraint.h"
#include "energy/laplacian.h"
#include "geometry/surface_index.h"
#include "mapping/energy_phases.h"
#include "solve/least_squares.h"

namespace partwise {
namespace {

/// Vertices that have their place: markers and the boundary.
std::vector<bool> held_vertices(const CompatibleMesh& mesh) {
  std::vector<bool> held(mesh.points.size(), false);
  for (std::size_t v = 0; v < held.size(); ++v) {
    held[v] = mesh.source.half_edges().is_boundary(OpenMesh::VertexHandle(static_cast<int>(v)));
  }
  for (const MarkerPair& marker : mesh.markers) {
    if (const std::optional<int> v = vertex_at(mesh.source, marker.source)) held[*v] = true;
  }
  return held;
}

double mean_edge_length(const Points& points, const Facets& facets) {
  double sum = 0;
  for (const auto& [a, b, c] : facets) {
    sum += (points[b] - points[a]).norm() + (points[c] - points[b]).norm() + (points[a] - points[c]).norm();
  }
  return sum / (3 * static_cast<double>(facets.size()));
}

/// The state of one call.
class Umbrella {
 public:
  Umbrella(const CompatibleMesh& mesh, const UmbrellaOptions& options)
      : mesh_(mesh),
        options_(options),
        target_(mesh.target),
        weights_(laplacian_weights(mesh.source, options.weights)),
        edge_(mean_edge_length(mesh.points, mesh.source.facets())),
        held_(held_vertices(mesh)),
        points_(mesh.points),
        directions_(mesh.points.size(), Vec3::Zero()),
        critical_of_(mesh.points.size(), -1) {}

  UmbrellaResult run() {
    for (int i = 0; i < options_.critical.iterations && !mesh_.critical_points.empty(); ++i)
      draw_to_critical();
    UmbrellaResult result;
    while (result.rounds < options_.rounds) {
      ++result.rounds;
      if (move_all() < options_.convergence * mesh_.target.diagonal()) break;
    }
    for (std::size_t v = 0; v < points_.size(); ++v) {
      const bool keeps = held_[v] && critical_of_[v] < 0;
      result.images.push_back(keeps ? mesh_.map[static_cast<int>(v)] : projected(static_cast<int>(v)));
      if (critical_of_[v] < 0) continue;
      const Vec3 place = position(mesh_.target, result.images.back());
      const Vec3& wanted = mesh_.target.point(critical_of_[v]);
      result.critical_reached += (place - wanted).norm() <= 1e-9 * mesh_.target.diagonal();
    }
    return result;
  }

 private:
  void draw_to_critical() {
    const SurfaceIndex surface(points_, mesh_.source.facets());
    std::vector<VertexTarget> fixed, drawn;
    for (std::size_t v = 0; v < points_.size(); ++v) {
      if (held_[v]) fixed.push_back({static_cast<int>(v), points_[v]});
    }
    std::fill(critical_of_.begin(), critical_of_.end(), -1);
    for (const CriticalPoint& point : mesh_.critical_points) {
      const Vec3& goal = mesh_.target.point(point.vertex);
      const SurfacePoint nearest = surface.closest(goal).point;
      int corner = 0;
      nearest.barycentric.maxCoeff(&corner);
      const int v = mesh_.source.facet(nearest.facet)[corner];
      if (held_[v] || critical_of_[v] >= 0) continue;  // the more curved point has it
      critical_of_[v] = point.vertex;
      drawn.push_back({v, goal});
    }
    const int count = static_cast<int>(points_.size());
    LeastSquares system(count, fixed);
    system.add(1, laplacian_detail_term(weights_, points_));
    system.add(options_.critical.weight, critical_constraint_term(count, drawn));  // Eq. (17)
    points_ = system.minimise();
  }

  /// One round of Eq. (18); returns the mean length of the moves.
  double move_all() {
    Points moved = points_;
    double sum = 0;
    for (std::size_t v = 0; v < points_.size(); ++v) {
      Vec3 umbrella = Vec3::Zero();
      for (VertexWeights::InnerIterator j(weights_, static_cast<int>(v)); j; ++j) {
        umbrella += j.value() * (points_[j.col()] - points_[v]);
      }
      directions_[v] = umbrella;
      if (held_[v] || critical_of_[v] >= 0 || umbrella.isZero(0)) continue;
      const std::optional<SurfaceHit> hit = hit_along(static_cast<int>(v));
      const double factor = hit && hit->distance > 0 ? options_.lambda * edge_ / hit->distance : 1;
      moved[v] += std::min(1.0, factor) * umbrella;
      sum += (moved[v] - points_[v]).norm();
    }
    points_ = std::move(moved);
    return sum / static_cast<double>(points_.size());
  }

  /// The nearer of both ways.
  std::optional<SurfaceHit> hit_along(int vertex) const {
    const Vec3& direction = directions_[vertex];
    if (direction.isZero(0)) return std::nullopt;
    const auto ahead = target_.first_hit(points_[vertex], direction);
    const auto behind = target_.first_hit(points_[vertex], -direction);
    if (!ahead || (behind && behind->distance < ahead->distance)) return behind;
    return ahead;
  }

  SurfacePoint projected(int vertex) const {
    if (critical_of_[vertex] < 0) {
      const auto hit = hit_along(vertex);
      if (hit && hit->distance <= edge_) return hit->point;
    } else if ((points_[vertex] - mesh_.target.point(critical_of_[vertex])).norm() <= edge_) {
      return target_.closest(mesh_.target.point(critical_of_[vertex])).point;
    }
    return target_.closest(points_[vertex]).point;
  }

  const CompatibleMesh& mesh_;
  const UmbrellaOptions& options_;
  SurfaceIndex target_;
  VertexWeights weights_;
  double edge_;  // mean length
  std::vector<bool> held_;
  Points points_;
  Points directions_;             // the last U of every vertex
  std::vector<int> critical_of_;  // per vertex: the critical target vertex it is drawn to, or -1
};

}  // namespace

UmbrellaResult relocate_by_umbrella(const CompatibleMesh& mesh, const UmbrellaOptions& options) {
  return Umbrella(mesh, options).run();
}

}  // namespace partwise
