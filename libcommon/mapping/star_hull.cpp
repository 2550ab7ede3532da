#include "mapping/star_hull.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "error.h"
#include "geometry/normals.h"

namespace partwise {

namespace {

/// Per facet: the one across the edge from corner i to i + 1.
std::vector<Facet> facets_across(const TriMesh& mesh) {
  const HalfEdges& half_edges = mesh.half_edges();
  std::vector<Facet> neighbours;
  for (const Facet& facet : mesh.facets()) {
    Facet across;
    for (int i = 0; i < 3; ++i) {
      const auto h = half_edges.find_halfedge(OpenMesh::VertexHandle(facet[i]),
                                              OpenMesh::VertexHandle(facet[(i + 1) % 3]));
      across[i] = half_edges.opposite_face_handle(h).idx();
    }
    neighbours.push_back(across);
  }
  return neighbours;
}

/// A facet's edges (by the corner they start at), longest first.
Facet edges_by_length(const Points& points, const Facet& facet) {
  auto length = [&](int i) { return (points[facet[(i + 1) % 3]] - points[facet[i]]).squaredNorm(); };
  Facet edges{0, 1, 2};
  std::stable_sort(edges.begin(), edges.end(), [&](int i, int j) { return length(i) > length(j); });
  return edges;
}

/// Per facet: itself, or for a sliver, whose normal is rounding, the facet that its plane is taken from. A
/// sliver lies in the plane of the facet across its longest edge, to within its own height; where two slivers
/// share that edge, in the one across the next.
std::vector<int> planes_of_facets(const Points& points, const Facets& facets,
                                  const std::vector<double>& areas, const std::vector<Facet>& across) {
  constexpr double kFlat = 1e-8;  // height over length
  std::vector<int> planes(facets.size(), -1);
  std::vector<int> slivers;
  for (int f = 0; f < static_cast<int>(facets.size()); ++f) {
    const int base = edges_by_length(points, facets[f])[0];
    const double length = (points[facets[f][(base + 1) % 3]] - points[facets[f][base]]).squaredNorm();
    if (2 * areas[f] < kFlat * length) {
      slivers.push_back(f);
    } else {
      planes[f] = f;
    }
  }
  for (int rank = 0; rank < 3 && !slivers.empty();) {
    const std::size_t before = slivers.size();
    std::erase_if(slivers, [&](int f) {
      planes[f] = planes[across[f][edges_by_length(points, facets[f])[rank]]];
      return planes[f] >= 0;
    });
    rank = slivers.size() < before ? 0 : rank + 1;
  }
  for (const int f : slivers) planes[f] = f;
  return planes;
}

}  // namespace

StarHull::StarHull(const ConvexHull& hull, const Vec3& centre) : points_(hull.points), facets_(hull.facets) {
  for (Vec3& point : points_) point -= centre;
  normals_ = facet_normals(points_, facets_);
  neighbours_ = facets_across(TriMesh(points_, facets_));
  const std::vector<double> areas = facet_areas(points_, facets_);
  area_ = std::accumulate(areas.begin(), areas.end(), 0.0);
  const std::vector<int> planes = planes_of_facets(points_, facets_, areas, neighbours_);
  const Points own_normals = normals_;
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    normals_[f] = own_normals[planes[f]];
    heights_.push_back(normals_[f].dot(points_[facets_[planes[f]][0]]));
    if (!(heights_.back() > 0))
      throw InputError("the centre lies outside the hull's facet " + std::to_string(f));
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

Eigen::Matrix3d StarHull::second_moments() const {
  const std::vector<double> areas = facet_areas(points_, facets_);
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    const Vec3 &a = points_[facets_[f][0]], &b = points_[facets_[f][1]], &c = points_[facets_[f][2]];
    const Vec3 total = a + b + c;
    sum += areas[f] / 12 *
           (a * a.transpose() + b * b.transpose() + c * c.transpose() + total * total.transpose());
  }
  return sum / area_;
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
