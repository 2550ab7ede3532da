#include "mesh/surface_walk.h"

#include <algorithm>
#include <limits>

#include "geometry/triangle_queries.h"

namespace partwise {
namespace {

int corner_of(const Facet& facet, int vertex) {
  const auto at = std::find(facet.begin(), facet.end(), vertex);
  return at == facet.end() ? -1 : static_cast<int>(at - facet.begin());
}

/// Rates of the barycentric coordinates of a point that moves by `velocity` in the plane of (a, b, c); zero
/// for a facet without area.
Vec3 barycentric_rates(const Vec3& velocity, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a);
  const double area = normal.squaredNorm();
  if (area == 0) return Vec3::Zero();
  const Vec3 turned =
      normal.cross(velocity) / area;  // gradient of corner i is normal x (edge facing i) / area
  return {-turned.dot(c - b), -turned.dot(a - c), -turned.dot(b - a)};
}

}  // namespace

SurfaceWalker::SurfaceWalker(const TriMesh& mesh)
    : mesh_(mesh), neighbours_(mesh.facet_count()), around_start_(mesh.vertex_count() + 1, 0) {
  const HalfEdges& half_edges = mesh_.half_edges();
  for (int f = 0; f < mesh_.facet_count(); ++f) {
    const Facet& facet = mesh_.facet(f);
    for (const auto h : half_edges.fh_range(OpenMesh::FaceHandle(f))) {
      const int corner = corner_of(facet, half_edges.from_vertex_handle(h).idx());
      neighbours_[f][corner] = half_edges.face_handle(half_edges.opposite_halfedge_handle(h)).idx();
    }
    for (const int v : facet) ++around_start_[v + 1];
  }
  for (int v = 0; v < mesh_.vertex_count(); ++v) around_start_[v + 1] += around_start_[v];
  around_.resize(3 * mesh_.facets().size());
  std::vector<int> next(around_start_.begin(), around_start_.end() - 1);
  for (int f = 0; f < mesh_.facet_count(); ++f) {
    for (const int v : mesh_.facet(f)) around_[next[v]++] = f;
  }
}

SurfacePoint seen_from(const TriMesh& mesh, const SurfacePoint& point, int facet) {
  SurfacePoint result{facet, Vec3::Zero()};
  for (int i = 0; i < 3; ++i) {
    if (point.barycentric[i] == 0) continue;
    const int corner = corner_of(mesh.facet(facet), mesh.facet(point.facet)[i]);
    if (corner < 0) return {};
    result.barycentric[corner] = point.barycentric[i];
  }
  return result;
}

SurfaceWalk SurfaceWalker::straight(const SurfacePoint& start, const Vec3& displacement) const {
  auto corner = [&](int f, int i) -> const Vec3& { return mesh_.point(mesh_.facet(f)[i]); };
  auto normal_of = [&](int f) -> Vec3 {
    return (corner(f, 1) - corner(f, 0)).cross(corner(f, 2) - corner(f, 0)).normalized();
  };
  SurfaceWalk walk{.end = start};
  SurfacePoint& at = walk.end;
  Vec3 normal = normal_of(at.facet);
  Vec3 remaining = displacement - normal.dot(displacement) * normal;
  const double total = remaining.norm();
  if (!(total > 0)) return walk;
  walk.direction = remaining / total;
  double left = total;
  const int most_crossings = 4 * mesh_.facet_count() + 16;
  for (int crossing = 0; crossing < most_crossings; ++crossing) {
    const Vec3 rates = barycentric_rates(left * walk.direction, corner(at.facet, 0), corner(at.facet, 1),
                                         corner(at.facet, 2));
    if (rates.isZero(0)) break;
    double share = 1;
    int leaves = -1;  // the corner whose coordinate falls to zero first
    for (int i = 0; i < 3; ++i) {
      if (rates[i] < 0 && at.barycentric[i] < -share * rates[i]) {
        share = at.barycentric[i] / -rates[i];
        leaves = i;
      }
    }
    at.barycentric = (at.barycentric + share * rates).cwiseMax(0);
    if (leaves >= 0) at.barycentric[leaves] = 0;
    at.barycentric /= at.barycentric.sum();
    left -= share * left;
    if (leaves < 0) {
      left = 0;
      break;
    }
    const int from = (leaves + 1) % 3;
    const int next = neighbours_[at.facet][from];
    walk.at_boundary = next < 0;
    if (next < 0) break;
    // Unfold: the share along the edge stays, the share across it turns into the next facet's plane.
    const Vec3 along = (corner(at.facet, (from + 1) % 3) - corner(at.facet, from)).normalized();
    const Vec3 across_here = along.cross(normal);  // out of this facet
    normal = normal_of(next);
    if (normal.isZero(0)) break;
    const Vec3 across_next = along.cross(normal);
    walk.direction = (walk.direction.dot(along) * along + walk.direction.dot(across_here) * across_next);
    walk.direction.normalize();
    at = seen_from(mesh_, at, next);
  }
  walk.length = total - left;
  return walk;
}

SurfacePoint SurfaceWalker::towards(const SurfacePoint& start, const Vec3& goal) const {
  auto closest_in = [&](int f) {
    const Facet& facet = mesh_.facet(f);
    const TriangleProximity closest =
        closest_on_triangle(goal, mesh_.point(facet[0]), mesh_.point(facet[1]), mesh_.point(facet[2]));
    return SurfacePoint{f, closest.barycentric};
  };
  auto distance_of = [&](const SurfacePoint& point) { return (position(mesh_, point) - goal).squaredNorm(); };
  SurfacePoint best = closest_in(start.facet);
  double best_distance = distance_of(best);
  while (true) {
    SurfacePoint found;
    double found_distance = best_distance * (1 - 1e-14);
    auto consider = [&](int facet) {
      if (facet < 0 || facet == best.facet) return;
      const SurfacePoint candidate = closest_in(facet);
      const double distance = distance_of(candidate);
      if (distance >= found_distance) return;
      found = candidate;
      found_distance = distance;
    };
    // The closest point of the facet lies inside it (done), on an edge, or at a vertex.
    for (int i = 0; i < 3; ++i) {
      if (best.barycentric[i] == 1) {
        for (const int facet : facets_around(mesh_.facet(best.facet)[i])) consider(facet);
      } else if (best.barycentric[i] == 0) {
        consider(neighbours_[best.facet][(i + 1) % 3]);
      }
    }
    if (found.facet < 0) return best;
    best = found;
    best_distance = found_distance;
  }
}

}  // namespace partwise
