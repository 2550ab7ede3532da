#include "measure/geodesic_search.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace partwise {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Distance of c from a source that is `to_a` from a and `to_b` from b: straight across the edge ab when the
/// straight line crosses it, along the sides ac or bc when not.
double distance_across(const Vec3& a, double to_a, const Vec3& b, double to_b, const Vec3& c) {
  const double along_sides = std::min(to_a + (c - a).norm(), to_b + (c - b).norm());
  const double edge = (b - a).norm();
  if (!(edge > 0) || !(std::abs(to_a - to_b) <= edge)) return along_sides;
  // The plane of the facet: a in the origin, b on the positive x axis, c above it, the source below.
  const double source_x = (to_a * to_a - to_b * to_b + edge * edge) / (2 * edge);
  const double source_depth = std::sqrt(std::max(0.0, to_a * to_a - source_x * source_x));
  const double c_x = (c - a).dot(b - a) / edge;
  const double c_height = (b - a).cross(c - a).norm() / edge;
  const double vertical = c_height + source_depth;
  if (!(vertical > 0)) return along_sides;
  const double crossing = source_x + (c_x - source_x) * source_depth / vertical;
  if (crossing < 0 || crossing > edge) return along_sides;
  return std::min(along_sides, std::hypot(c_x - source_x, vertical));
}

}  // namespace

struct GeodesicSearch::Front {
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
};

GeodesicSearch::GeodesicSearch(const TriMesh& mesh)
    : mesh_(mesh), distance_(mesh.vertex_count(), kInfinity), known_(mesh.vertex_count(), 0) {}

double GeodesicSearch::distance(int vertex, const SurfacePoint& goal) {
  for (const int v : touched_) {
    distance_[v] = kInfinity;
    known_[v] = 0;
  }
  touched_.assign(1, vertex);
  distance_[vertex] = 0;
  Front front;
  front.queue.emplace(0, vertex);
  const Facet& last = mesh_.facet(goal.facet);
  int corners_left = 3;
  while (!front.queue.empty() && corners_left > 0) {
    const int nearest = front.queue.top().second;
    front.queue.pop();
    if (known_[nearest]) continue;
    known_[nearest] = 1;
    corners_left -= static_cast<int>(std::count(last.begin(), last.end(), nearest));
    relax_around(nearest, front);
  }
  return corners_left == 0 ? distance_inside(goal) : kInfinity;
}

void GeodesicSearch::relax_around(int vertex, Front& front) {
  auto lower = [&](int v, double distance) {
    if (known_[v] || !(distance < distance_[v])) return;
    if (distance_[v] == kInfinity) touched_.push_back(v);
    distance_[v] = distance;
    front.queue.emplace(distance, v);
  };
  const Vec3& at = mesh_.point(vertex);
  for (const auto handle : mesh_.half_edges().vf_range(OpenMesh::VertexHandle(vertex))) {
    const Facet& f = mesh_.facet(handle.idx());
    const auto corner = std::find(f.begin(), f.end(), vertex) - f.begin();
    const int next = f[(corner + 1) % 3], previous = f[(corner + 2) % 3];
    for (const auto& [v, other] : {std::pair(next, previous), std::pair(previous, next)}) {
      const double straight = distance_[vertex] + (mesh_.point(v) - at).norm();
      lower(v, known_[other] ? distance_across(at, distance_[vertex], mesh_.point(other), distance_[other],
                                               mesh_.point(v))
                             : straight);
    }
  }
}

double GeodesicSearch::distance_inside(const SurfacePoint& goal) const {
  const Vec3 point = position(mesh_, goal);
  const Facet& f = mesh_.facet(goal.facet);
  double nearest = kInfinity;
  for (int i = 0; i < 3; ++i) {
    const int a = f[i], b = f[(i + 1) % 3];
    nearest =
        std::min(nearest, distance_across(mesh_.point(a), distance_[a], mesh_.point(b), distance_[b], point));
  }
  return nearest;
}

}  // namespace partwise
