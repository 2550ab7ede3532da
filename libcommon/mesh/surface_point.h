#pragma once

#include <optional>

#include "mesh/tri_mesh.h"

namespace partwise {

/// A point on a mesh: a facet and barycentric coordinates (non-negative, sum 1) in the order of its vertices.
struct SurfacePoint {
  int facet = -1;
  Vec3 barycentric = Vec3::Zero();
};

/// Position of `point` on `mesh`. \pre 0 <= point.facet < mesh.facet_count()
inline Vec3 position(const TriMesh& mesh, const SurfacePoint& point) {
  const Facet& f = mesh.facet(point.facet);
  return point.barycentric[0] * mesh.point(f[0]) + point.barycentric[1] * mesh.point(f[1]) +
         point.barycentric[2] * mesh.point(f[2]);
}

/// The vertex of `mesh` that a point of it is, within rounding; nothing when it lies inside a facet or an
/// edge.
std::optional<int> vertex_at(const TriMesh& mesh, const SurfacePoint& point);

/// The place of a vertex, on the first of its facets. \pre `vertex` has a facet
SurfacePoint vertex_point(const TriMesh& mesh, int vertex);

/// Image on a target mesh of every vertex of a source mesh. Knows both meshes: using it with others throws.
class SurfaceMap {
 public:
  /// \throws InputError when sizes, facets or barycentric coordinates do not fit the meshes.
  SurfaceMap(const TriMesh& source, const TriMesh& target, std::vector<SurfacePoint> images);

  const SurfacePoint& operator[](int source_vertex) const { return images_[source_vertex]; }
  const std::vector<SurfacePoint>& images() const { return images_; }

  /// Positions of all images. \throws InputError when `target` is not the mesh the map leads to.
  Points positions(const TriMesh& target) const;

 private:
  MeshKey target_key_;
  std::vector<SurfacePoint> images_;
};

}  // namespace partwise
