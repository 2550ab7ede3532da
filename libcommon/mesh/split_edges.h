#pragma once

#include <vector>

#include "mesh/surface_point.h"

namespace partwise {

/// A point on the edge between two vertices: a + fraction (b - a).
struct EdgePoint {
  int a = 0;
  int b = 0;
  double fraction = 0;  ///< above 0 and below 1
};

/// A mesh with vertices added on its edges; the same surface.
struct EdgeSplitMesh {
  TriMesh mesh;                   ///< the first vertices are the original's, then one per point, in order
  std::vector<int> parent_facet;  ///< per facet of `mesh`: the facet of the original it is a piece of
  std::vector<EdgePoint> points;  ///< per added vertex: where it lies on the original

  /// A point of `mesh` as a point of `original`, the mesh it was made from.
  SurfacePoint on_original(const TriMesh& original, const SurfacePoint& point) const;
};

/// Adds vertices on edges and cuts the facets beside them.
///
/// A cut facet becomes a fan around that of its vertices that comes last in the numbering, if none of the
/// fan's facets is flat; so a vertex added later is a corner of every piece of the facets beside it.
/// \throws InputError naming the point that is on no edge of the mesh, outside it or twice the same
EdgeSplitMesh split_edges(const TriMesh& mesh, const std::vector<EdgePoint>& points);

}  // namespace partwise
