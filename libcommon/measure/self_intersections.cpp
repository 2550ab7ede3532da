#include "measure/self_intersections.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <iterator>

namespace partwise {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Triangle = Kernel::Triangle_3;
using Segment = Kernel::Segment_3;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;

/// Exact tests between facets of one mesh.
class FacetPairTest {
 public:
  FacetPairTest(const Points& points, const Facets& facets) : facets_(facets) {
    points_.reserve(points.size());
    for (const Vec3& point : points) points_.emplace_back(point.x(), point.y(), point.z());
  }

  bool has_area(int f) const { return !CGAL::collinear(corner(f, 0), corner(f, 1), corner(f, 2)); }

  Triangle triangle(int f) const { return {corner(f, 0), corner(f, 1), corner(f, 2)}; }

  bool intersect(int f, int g) const {
    const auto f_rotations = common_corners(f, g), g_rotations = common_corners(g, f);
    switch (f_rotations.size()) {
      case 0:
        return CGAL::do_intersect(triangle(f), triangle(g));
      case 1: {
        const int i = f_rotations[0], j = g_rotations[0];
        return CGAL::do_intersect(opposite(f, i), triangle(g)) ||
               CGAL::do_intersect(opposite(g, j), triangle(f));
      }
      case 2:
        return overlap_across_edge(f, g, f_rotations, g_rotations);
      default:
        return true;
    }
  }

 private:
  const Point& corner(int f, int i) const { return points_[facets_[f][i % 3]]; }
  Segment opposite(int f, int i) const { return {corner(f, i + 1), corner(f, i + 2)}; }

  /// Corners of f that are also corners of g.
  std::vector<int> common_corners(int f, int g) const {
    std::vector<int> corners;
    for (int i = 0; i < 3; ++i) {
      if (std::find(facets_[g].begin(), facets_[g].end(), facets_[f][i]) != facets_[g].end()) {
        corners.push_back(i);
      }
    }
    return corners;
  }

  /// Two facets over an edge overlap when they lie in one plane with their third corners on the same side.
  bool overlap_across_edge(int f, int g, const std::vector<int>& f_common,
                           const std::vector<int>& g_common) const {
    const Point &a = corner(f, f_common[0]), &b = corner(f, f_common[1]);
    const Point& c = corner(f, 3 - f_common[0] - f_common[1]);
    const Point& d = corner(g, 3 - g_common[0] - g_common[1]);
    return CGAL::coplanar(a, b, c, d) && CGAL::coplanar_orientation(a, b, c, d) == CGAL::POSITIVE;
  }

  std::vector<Point> points_;
  const Facets& facets_;
};

}  // namespace

std::vector<std::pair<int, int>> self_intersections(const Points& points, const Facets& facets) {
  const FacetPairTest test(points, facets);
  std::vector<Box> boxes;
  boxes.reserve(facets.size());
  for (int f = 0; f < static_cast<int>(facets.size()); ++f) {
    if (test.has_area(f)) boxes.emplace_back(test.triangle(f).bbox(), f);
  }
  std::vector<std::pair<int, int>> pairs;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    const auto [smaller, larger] = std::minmax({a.info(), b.info()});
    if (test.intersect(smaller, larger)) pairs.emplace_back(smaller, larger);
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace partwise
