#include "remeshing/mesh_on_surface.h"

#include <algorithm>
#include <cmath>

#include "geometry/normals.h"

namespace partwise {

MeshOnSurface::MeshOnSurface(const CompatibleMesh& mesh)
    : source_(mesh.source),
      source_walker_(mesh.source),
      walker_(mesh.target),
      target_normals_(vertex_normals(mesh.target.points(), mesh.target.facets())),
      points_(mesh.points),
      normals_(mesh.points.size()),
      images_(mesh.map.images()),
      pinned_(mesh.points.size(), false),
      guard_(mesh) {
  for (int v = 0; v < source_.vertex_count(); ++v) {
    place(v, images_[v]);
    pinned_[v] = source_.half_edges().is_boundary(OpenMesh::VertexHandle(v)) || guard_.is_held(v);
  }
  for (const MarkerPair& marker : mesh.markers) {
    if (const std::optional<int> v = vertex_at(source_, marker.source)) pinned_[*v] = true;
  }
}

Vec3 MeshOnSurface::normal_at(const SurfacePoint& image) const {
  const Facet& f = target().facet(image.facet);
  Vec3 normal = Vec3::Zero();
  for (int i = 0; i < 3; ++i) normal += image.barycentric[i] * target_normals_[f[i]];
  return normal.stableNormalized();
}

double MeshOnSurface::quality(int facet) const {
  const auto& [a, b, c] = source_.facet(facet);
  const Vec3 area = area_vector(points_[a], points_[b], points_[c]);
  const double edges = (points_[b] - points_[a]).squaredNorm() + (points_[c] - points_[b]).squaredNorm() +
                       (points_[a] - points_[c]).squaredNorm();
  if (edges == 0) return 0;
  const Vec3 normal = normals_[a] + normals_[b] + normals_[c];
  const double length = normal.norm();
  // Opposite normals at the corners say nothing of the facet's side.
  const double signed_area = length > 1e-9 ? area.dot(normal) / length : area.norm();
  return 2 * std::sqrt(3.0) * signed_area / edges;
}

int MeshOnSurface::flipped_count() const {
  int count = 0;
  for (int f = 0; f < source_.facet_count(); ++f) count += quality(f) < 0;
  return count;
}

MeshOnSurface::RingState MeshOnSurface::ring_state(int vertex) const {
  RingState state;
  for (const int f : ring(vertex)) {
    const double q = quality(f);
    state.flipped += q < 0;
    state.worst = std::min(state.worst, q);
  }
  return state;
}

void MeshOnSurface::place(int vertex, const SurfacePoint& image) {
  images_[vertex] = image;
  points_[vertex] = position(target(), image);
  normals_[vertex] = normal_at(image);
  guard_.place(vertex, image);
}

bool MeshOnSurface::move_to(int vertex, const SurfacePoint& image, double least_quality) {
  if (pinned_[vertex] || !allows(vertex, image)) return false;
  const SurfacePoint old = images_[vertex];
  const RingState before = ring_state(vertex);
  place(vertex, image);
  const RingState after = ring_state(vertex);
  const bool worse = after.flipped > before.flipped || after.worst < std::min(before.worst, least_quality);
  if (worse) place(vertex, old);
  return !worse;
}

bool MeshOnSurface::move_towards(int vertex, const Vec3& goal, int halvings) {
  if (pinned_[vertex]) return false;
  Vec3 step = goal - points_[vertex];
  for (int i = 0; i <= halvings; ++i) {
    if (move_to(vertex, walker_.towards(images_[vertex], points_[vertex] + step))) return true;
    step /= 2;
  }
  return false;
}

}  // namespace partwise
