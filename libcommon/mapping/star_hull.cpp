#include "mapping/star_hull.h"

#include <numeric>

#include "error.h"
#include "geometry/normals.h"

namespace partwise {

StarHull::StarHull(const ConvexHull& hull, const Vec3& centre) : points_(hull.points), facets_(hull.facets) {
  for (Vec3& point : points_) point -= centre;
  normals_ = facet_normals(points_, facets_);
  const std::vector<double> areas = facet_areas(points_, facets_);
  area_ = std::accumulate(areas.begin(), areas.end(), 0.0);
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    heights_.push_back(normals_[f].dot(points_[facets_[f][0]]));
    if (!(heights_.back() > 0))
      throw InputError("the centre lies outside the hull's facet " + std::to_string(f));
  }
  const TriMesh mesh(points_, facets_);
  const HalfEdges& half_edges = mesh.half_edges();
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    Facet across;
    for (int i = 0; i < 3; ++i) {
      const auto h = half_edges.find_halfedge(OpenMesh::VertexHandle(facets_[f][i]),
                                              OpenMesh::VertexHandle(facets_[f][(i + 1) % 3]));
      across[i] = half_edges.opposite_face_handle(h).idx();
    }
    neighbours_.push_back(across);
  }
}

StarHull::Place StarHull::project(const Vec3& direction, int hint) const {
  // Seen from inside, a convex hull is a regular subdivision of the sphere, on which this walk cannot cycle;
  // the bound only guards against rounding at an edge, where either side is right.
  int facet = hint;
  for (std::size_t step = 0; step < 4 * facets_.size() + 8; ++step) {
    int next = -1;
    double worst = 0;
    for (int i = 0; i < 3; ++i) {
      const Vec3& a = points_[facets_[facet][i]];
      const Vec3& b = points_[facets_[facet][(i + 1) % 3]];
      const double side = direction.dot(a.cross(b));
      if (side < worst) {
        worst = side;
        next = neighbours_[facet][i];
      }
    }
    if (next < 0) break;
    facet = next;
  }
  return {facet, direction * (heights_[facet] / normals_[facet].dot(direction))};
}

std::vector<StarHull::Place> StarHull::project(const Points& directions) const {
  std::vector<Place> places;
  places.reserve(directions.size());
  int hint = 0;
  for (const Vec3& direction : directions) {
    places.push_back(project(direction, hint));
    hint = places.back().facet;
  }
  return places;
}

}  // namespace partwise
