#pragma once

#include <vector>

#include "mesh/surface_point.h"

namespace partwise {

/// Geodesic distances on a mesh from a vertex to a point of the surface, in the units of the mesh.
///
/// Dijkstra's search over the vertices in which a distance may also cross facets: where two vertices of a
/// facet are known, the third is reached in a straight line across their edge in the unfolded plane (Novotni
/// and Klein 2002). Exact within the facets around the start and wherever the surface between unfolds into
/// a plane with acute facets; otherwise mostly too long, by about a percent on smooth meshes with good facets
/// and never by more than the detour along edges. The search ends as soon as the goal's facet is known, so
/// near points cost little.
///
/// Holds scratch memory: use one per thread. Keeps a reference to the mesh.
class GeodesicSearch {
 public:
  explicit GeodesicSearch(const TriMesh& mesh);

  /// Infinite when no path joins the two. \pre vertex and goal lie on the mesh
  double distance(int vertex, const SurfacePoint& goal);

 private:
  struct Front;
  void relax_around(int vertex, Front& front);
  double distance_inside(const SurfacePoint& goal) const;

  const TriMesh& mesh_;
  std::vector<double> distance_;
  std::vector<char> known_;
  std::vector<int> touched_;
};

}  // namespace partwise
