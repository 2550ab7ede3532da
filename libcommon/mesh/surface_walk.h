#pragma once

#include <array>
#include <vector>

#include "mesh/surface_point.h"

namespace partwise {

/// Where a walk ended, and why.
struct SurfaceWalk {
  SurfacePoint end;
  Vec3 direction = Vec3::Zero();  ///< unit direction at the end, in the plane of the last facet
  double length = 0;              ///< walked, in units of the model
  bool at_boundary = false;       ///< ended early at the mesh's boundary
};

/// Moves points over a surface from facet to facet, so that they never jump to another sheet that is near in
/// space (lips, fingers). Immutable after construction; walks may run concurrently.
class SurfaceWalker {
 public:
  explicit SurfaceWalker(const TriMesh& mesh);

  const TriMesh& mesh() const { return mesh_; }

  /// Straight walk: the line from `start` along the tangential part of `displacement` (in the plane of the
  /// start's facet) for its length, unfolded over every edge it crosses. Ends early at the boundary of the
  /// mesh and in facets without area.
  SurfaceWalk straight(const SurfacePoint& start, const Vec3& displacement) const;

  /// Closest point to `goal` that is reached from `start` by getting closer all the way, a local minimum of
  /// the distance: the projection of `goal` onto the sheet on which `start` lies.
  SurfacePoint towards(const SurfacePoint& start, const Vec3& goal) const;

  /// Facet beside edge (corner, corner + 1) of `facet`, or -1 at the boundary.
  int neighbour(int facet, int corner) const { return neighbours_[facet][corner]; }

  /// Facets around a vertex, ascending.
  struct FacetRange {
    const int *first, *last;
    const int* begin() const { return first; }
    const int* end() const { return last; }
  };
  FacetRange facets_around(int vertex) const {
    return {around_.data() + around_start_[vertex], around_.data() + around_start_[vertex + 1]};
  }

 private:
  TriMesh mesh_;
  std::vector<std::array<int, 3>> neighbours_;
  std::vector<int> around_start_, around_;
};

/// `point` as a point of a facet that has the vertices of all its non-zero coordinates, or nothing (facet -1)
/// when `facet` is no such facet. For moving a point on an edge or vertex to the facet beside it.
SurfacePoint seen_from(const TriMesh& mesh, const SurfacePoint& point, int facet);

}  // namespace partwise
