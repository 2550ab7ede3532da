#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

#include "geometry/convex_hull.h"
#include "geometry/normals.h"
#include "geometry/surface_index.h"

namespace partwise {
namespace {

constexpr double kThinnest = 1e-7;  // height over longest edge of a facet whose plane is well defined
constexpr double kOutside = 1e-9;   // over the diagonal: farther outside, a point is no point of the hull
constexpr std::ptrdiff_t kLeafSize = 16;
constexpr std::size_t kFewPlanes = 6;
constexpr std::ptrdiff_t kLargestTask = 4096;  // points measured by one thread in one go

struct Plane {
  Vec3 normal;  // unit, outward
  double offset;

  double depth(const Vec3& p) const { return offset - normal.dot(p); }
};

/// Planes of the facets. A sliver's is left out: those of its neighbours bound the hull as well, up to its
/// height.
std::vector<Plane> planes_of(const ConvexHull& hull) {
  std::vector<Plane> planes;
  for (const auto& [i, j, k] : hull.facets) {
    const Vec3 &a = hull.points[i], &b = hull.points[j], &c = hull.points[k];
    const Vec3 vector = area_vector(a, b, c);
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    if (vector.norm() < kThinnest * longest) continue;
    const Vec3 normal = vector.stableNormalized();
    planes.push_back({normal, normal.dot(a + b + c) / 3});
  }
  return planes;
}

/// Distance from points inside a convex hull to the nearest of its planes, which is that to its surface.
///
/// Points are halved by space; of a cell's planes only those stay that can be nearest to one of its points.
class Depths {
 public:
  Depths(const Points& points, const std::vector<Plane>& planes)
      : points_(points), order_(points.size()), depths_(points.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    if (!points.empty()) measure(order_.begin(), order_.end(), planes);
  }
  std::vector<double> values() && { return std::move(depths_); }

 private:
  using Iterator = std::vector<int>::iterator;

  void measure(Iterator begin, Iterator end, const std::vector<Plane>& planes) {
    Eigen::AlignedBox3d box;
    for (auto i = begin; i != end; ++i) box.extend(points_[*i]);
    const std::vector<Plane> near = possibly_nearest(box, planes);
    if (end - begin <= kLeafSize || near.size() <= kFewPlanes) {
      for (auto i = begin; i != end; ++i) depths_[*i] = smallest_depth(points_[*i], near);
      return;
    }
    int axis = 0;
    box.sizes().maxCoeff(&axis);
    const Iterator middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end, [&](int a, int b) { return points_[a][axis] < points_[b][axis]; });
    const auto lower = [&] { measure(begin, middle, near); };
    const auto upper = [&] { measure(middle, end, near); };
    if (end - begin > kLargestTask) {
      tbb::parallel_invoke(lower,
                           upper);  // every point's depth is its own: the same on any number of threads
    } else {
      lower();
      upper();
    }
  }

  static double smallest_depth(const Vec3& point, const std::vector<Plane>& planes) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const Plane& plane : planes) smallest = std::min(smallest, plane.depth(point));
    return smallest;
  }

  static std::vector<Plane> possibly_nearest(const Eigen::AlignedBox3d& box,
                                             const std::vector<Plane>& planes) {
    const Vec3 centre = box.center();
    const double reach = smallest_depth(centre, planes) + box.diagonal().norm() * (1 + 1e-9);
    std::vector<Plane> near;
    for (const Plane& plane : planes) {
      if (plane.depth(centre) <= reach) near.push_back(plane);
    }
    return near;
  }

  const Points& points_;
  std::vector<int> order_;
  std::vector<double> depths_;
};

}  // namespace

std::vector<double> distances_to_hull(const ConvexHull& hull, const Points& points) {
  std::vector<double> distances = Depths(points, planes_of(hull)).values();
  const double outside = -kOutside * bounding_box_diagonal(hull.points);
  std::optional<SurfaceIndex> index;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (distances[i] < outside) {
      if (!index) index.emplace(hull.points, hull.facets);
      distances[i] = index->closest(points[i]).distance;
    }
    distances[i] = std::max(distances[i], 0.0);
  }
  return distances;
}

}  // namespace partwise
