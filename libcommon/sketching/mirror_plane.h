#pragma once

#include "geometry/surface_index.h"

namespace partwise::sketching {

/// The points x with normal . x = offset.
struct MirrorPlane {
  Vec3 normal = Vec3::UnitX();  ///< unit
  double offset = 0;
  /// Root of the mean squared distance between the surface and its mirror image, over the mesh's diagonal.
  double error = 0;

  Vec3 mirrored(const Vec3& point) const { return point - 2 * (normal.dot(point) - offset) * normal; }
};

/// The plane about which a surface is most nearly its own mirror image: exact where there is one that it is
/// symmetric about, the best that was found where there is none.
///
/// Planes through the centroid, normal to the principal axes and to directions spread over the sphere, are
/// compared by a few samples of the surface; the best are improved by Gauss-Newton steps that bring the
/// mirrored samples onto the surface (iterative closest points, by distance to the facets' planes), limbs
/// that are posed differently counting less. The same surface gives the same plane each time; of equally
/// good planes it gives one. \pre the mesh has area
MirrorPlane find_mirror_plane(const TriMesh& mesh, const SurfaceIndex& surface);

}  // namespace partwise::sketching
