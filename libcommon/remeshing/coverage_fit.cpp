#include "remeshing/coverage_fit.h"

#include <algorithm>
#include <array>
#include <limits>

#include "geometry/surface_index.h"
#include "geometry/triangle_queries.h"
#include "remeshing/intersection_guard.h"

namespace partwise {
namespace {

/// One round: which target vertices are nearest to which facets, and the moves that bring them nearer.
class Round {
 public:
  /// \param threshold over the diagonal
  Round(MeshOnSurface& mesh, double threshold, double least_quality)
      : mesh_(mesh),
        intersections_(mesh),
        least_quality_(least_quality),
        facet_of_(mesh.target().vertex_count()),
        nearest_to_(mesh.source().facet_count()),
        moved_(mesh.points().size(), false),
        attempts_(mesh.points().size(), 0) {
    const SurfaceIndex surface(mesh.points(), mesh.source().facets());
    const double reach = threshold * mesh.target().diagonal();
    for (int t = 0; t < mesh.target().vertex_count(); ++t) {
      const SurfaceHit hit = surface.closest(mesh.target().point(t));
      facet_of_[t] = hit.point.facet;
      nearest_to_[hit.point.facet].push_back(t);
      if (hit.distance > reach) far_.push_back({hit.distance, t});
    }
    std::sort(far_.begin(), far_.end(), [](const Far& a, const Far& b) {
      return a.distance > b.distance || (a.distance == b.distance && a.vertex < b.vertex);
    });
  }

  int run() {
    int moves = 0;
    for (const Far& far : far_) moves += pull(far.vertex);
    return moves;
  }

 private:
  /// A vertex that so many pulls did not move stays: a target much finer than the mesh has many of them.
  static constexpr int kMostAttempts = 8;

  struct Far {
    double distance;
    int vertex;
  };

  bool pull(int target_vertex) {
    const Vec3& goal = mesh_.target().point(target_vertex);
    std::array<int, 3> corners = mesh_.source().facet(facet_of_[target_vertex]);
    std::sort(corners.begin(), corners.end(), [&](int a, int b) {
      return (mesh_.points()[a] - goal).squaredNorm() < (mesh_.points()[b] - goal).squaredNorm();
    });
    for (const int corner : corners) {
      if (mesh_.is_pinned(corner) || moved_[corner] || attempts_[corner] == kMostAttempts) continue;
      ++attempts_[corner];
      const Vec3 from = mesh_.points()[corner];
      if (try_move(corner, goal) || try_move(corner, (from + goal) / 2)) return moved_[corner] = true;
    }
    return false;
  }

  bool try_move(int vertex, const Vec3& goal) {
    const SurfacePoint old = mesh_.image(vertex);
    const SurfacePoint reached = mesh_.walker().towards(old, goal);
    if (!mesh_.move_to(vertex, reached, least_quality_)) return false;
    const double after = local_error(vertex);
    mesh_.place(vertex, old);
    if (after >= local_error(vertex) * (1 - 1e-6)) return false;
    const int intersections = intersections_.count_around(vertex);
    mesh_.place(vertex, reached);
    if (intersections_.count_around(vertex) > intersections) {
      mesh_.place(vertex, old);
      return false;
    }
    intersections_.moved(vertex);
    return true;
  }

  /// Sum of the squared distances to the ring of the target vertices that were nearest to its facets.
  double local_error(int vertex) const {
    double sum = 0;
    for (const int owner : mesh_.ring(vertex)) {
      for (const int t : nearest_to_[owner]) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const int f : mesh_.ring(vertex)) {
          const auto& [a, b, c] = mesh_.source().facet(f);
          nearest = std::min(nearest, closest_on_triangle(mesh_.target().point(t), mesh_.points()[a],
                                                          mesh_.points()[b], mesh_.points()[c])
                                          .squared_distance);
        }
        sum += nearest;
      }
    }
    return sum;
  }

  MeshOnSurface& mesh_;
  IntersectionGuard intersections_;
  double least_quality_;
  std::vector<int> facet_of_;
  std::vector<std::vector<int>> nearest_to_;
  std::vector<Far> far_;
  std::vector<bool> moved_;
  std::vector<int> attempts_;
};

int fit_rounds(MeshOnSurface& mesh, int rounds, double threshold, double least_quality) {
  int total = 0;
  for (int i = 0; i < rounds; ++i) {
    const int moves = Round(mesh, threshold, least_quality).run();
    total += moves;
    if (moves == 0) break;
  }
  return total;
}

}  // namespace

int fit_coverage(MeshOnSurface& mesh, const CoverageFitOptions& options) {
  const int moves = fit_rounds(mesh, options.rounds, options.threshold, options.least_quality);
  return moves + fit_rounds(mesh, options.far_rounds, options.far_threshold, options.far_least_quality);
}

}  // namespace partwise
