#include "geometry/facet_intersection.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <vector>

namespace partwise {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

/// Exact tests between two facets of one mesh.
class FacetPair {
 public:
  FacetPair(const Points& points, const Facet& f, const Facet& g) : points_(points), f_(f), g_(g) {}

  bool intersect() const {
    const auto of_f = common_corners(f_, g_), of_g = common_corners(g_, f_);
    switch (of_f.size()) {
      case 0:
        return CGAL::do_intersect(triangle(f_), triangle(g_));
      case 1:
        return CGAL::do_intersect(opposite(f_, of_f[0]), triangle(g_)) ||
               CGAL::do_intersect(opposite(g_, of_g[0]), triangle(f_));
      case 2:
        return overlap_across_edge(of_f, of_g);
      default:
        return true;
    }
  }

 private:
  Point corner(const Facet& facet, int i) const {
    const Vec3& point = points_[facet[i % 3]];
    return {point.x(), point.y(), point.z()};
  }
  Kernel::Triangle_3 triangle(const Facet& f) const { return {corner(f, 0), corner(f, 1), corner(f, 2)}; }
  Kernel::Segment_3 opposite(const Facet& f, int i) const { return {corner(f, i + 1), corner(f, i + 2)}; }

  static std::vector<int> common_corners(const Facet& f, const Facet& g) {
    std::vector<int> corners;
    for (int i = 0; i < 3; ++i) {
      if (std::find(g.begin(), g.end(), f[i]) != g.end()) corners.push_back(i);
    }
    return corners;
  }

  /// Two facets over an edge overlap when they lie in one plane with their third corners on the same side.
  bool overlap_across_edge(const std::vector<int>& of_f, const std::vector<int>& of_g) const {
    const Point a = corner(f_, of_f[0]), b = corner(f_, of_f[1]);
    const Point c = corner(f_, 3 - of_f[0] - of_f[1]), d = corner(g_, 3 - of_g[0] - of_g[1]);
    return CGAL::coplanar(a, b, c, d) && CGAL::coplanar_orientation(a, b, c, d) == CGAL::POSITIVE;
  }

  const Points& points_;
  const Facet &f_, &g_;
};

}  // namespace

bool facets_intersect(const Points& points, const Facet& f, const Facet& g) {
  return FacetPair(points, f, g).intersect();
}

bool has_area(const Points& points, const Facet& facet) {
  auto corner = [&](int i) {
    const Vec3& point = points[facet[i]];
    return Point(point.x(), point.y(), point.z());
  };
  return !CGAL::collinear(corner(0), corner(1), corner(2));
}

}  // namespace partwise
