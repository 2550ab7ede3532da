#include "measure/self_intersections.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>

#include "geometry/facet_intersection.h"

namespace partwise {
namespace {

using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;

CGAL::Bbox_3 bounding_box(const Points& points, const Facet& facet) {
  CGAL::Bbox_3 box;
  for (const int v : facet)
    box += CGAL::Bbox_3(points[v].x(), points[v].y(), points[v].z(), points[v].x(), points[v].y(),
                        points[v].z());
  return box;
}

}  // namespace

std::vector<std::pair<int, int>> self_intersections(const Points& points, const Facets& facets) {
  std::vector<Box> boxes;
  boxes.reserve(facets.size());
  for (int f = 0; f < static_cast<int>(facets.size()); ++f) {
    if (has_area(points, facets[f])) boxes.emplace_back(bounding_box(points, facets[f]), f);
  }
  std::vector<std::pair<int, int>> pairs;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    const auto [smaller, larger] = std::minmax({a.info(), b.info()});
    if (facets_intersect(points, facets[smaller], facets[larger])) pairs.emplace_back(smaller, larger);
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace partwise
