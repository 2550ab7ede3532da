#include "geometry/convex_hull.h"

#include <CGAL/Convex_hull_traits_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <string>

#include "error.h"
#include "geometry/flat_sides.h"
#include "geometry/hull_candidates.h"
#include "geometry/normals.h"
#include "geometry/orientation.h"

namespace partwise {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
/// The plain kernel would construct planes in floating point; these traits decide by their three points.
using ExactTraits = CGAL::Convex_hull_traits_3<Kernel, CGAL::Default, CGAL::Tag_true>;

struct Corner {
  Point point;
  int input = 0;
};

/// Distinct points in lexicographic order, so that nothing after it depends on the order of the input.
std::vector<Corner> distinct_corners(const Points& points, const std::vector<int>& candidates) {
  std::vector<Corner> corners;
  corners.reserve(candidates.size());
  for (const int i : candidates) {
    corners.push_back({Point(points[i].x(), points[i].y(), points[i].z()), i});
  }
  std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) {
    const auto order = CGAL::compare_xyz(a.point, b.point);
    return order != CGAL::EQUAL ? order == CGAL::SMALLER : a.input < b.input;
  });
  const auto same = [](const Corner& a, const Corner& b) { return a.point == b.point; };
  corners.erase(std::unique(corners.begin(), corners.end(), same), corners.end());
  return corners;
}

bool all_in_one_plane(const std::vector<Corner>& corners) {
  const Point& a = corners.front().point;
  const auto b = std::next(corners.begin());
  const auto c = std::find_if(
      b, corners.end(), [&](const Corner& corner) { return !CGAL::collinear(a, b->point, corner.point); });
  return std::all_of(c, corners.end(), [&](const Corner& corner) {
    return CGAL::coplanar(a, b->point, c->point, corner.point);
  });
}

/// Facets of the hull as indices into `corners`.
Facets hull_facets(const std::vector<Corner>& corners) {
  std::vector<Point> input, vertices;
  for (const Corner& corner : corners) input.push_back(corner.point);
  std::vector<std::array<int, 3>> facets;
  using Input = std::vector<Point>::const_iterator;
  CGAL::convex_hull_3<Input, Point>(input.cbegin(), input.cend(), vertices, facets, ExactTraits());
  for (auto& facet : facets) {
    for (int& vertex : facet) {
      const auto found =
          std::lower_bound(corners.begin(), corners.end(), vertices[vertex],
                           [](const Corner& corner, const Point& p) { return corner.point < p; });
      vertex = static_cast<int>(found - corners.begin());
    }
  }
  return facets;
}

/// Whether the planes of the facets around a hull vertex meet in a point: three of them are needed.
bool is_extreme(const std::vector<Corner>& corners, const Facets& facets, const std::vector<int>& around) {
  const auto corner = [&](int facet, int i) -> const Point& { return corners[facets[facet][i]].point; };
  const auto same_plane = [&](int f, int g) {
    for (int i = 0; i < 3; ++i) {
      if (!CGAL::coplanar(corner(f, 0), corner(f, 1), corner(f, 2), corner(g, i))) return false;
    }
    return true;
  };
  std::vector<int> planes;
  for (const int f : around) {
    if (std::none_of(planes.begin(), planes.end(), [&](int g) { return same_plane(f, g); }))
      planes.push_back(f);
  }
  return planes.size() >= 3;
}

/// The corners that are extreme points; the others lie inside the hull, a flat side, or an edge of it.
std::vector<Corner> extreme_corners(const std::vector<Corner>& corners, const Facets& facets) {
  std::vector<std::vector<int>> around(corners.size());
  for (std::size_t f = 0; f < facets.size(); ++f) {
    for (const int vertex : facets[f]) around[vertex].push_back(static_cast<int>(f));
  }
  std::vector<Corner> extreme;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (is_extreme(corners, facets, around[i])) extreme.push_back(corners[i]);
  }
  return extreme;
}

/// Hull vertices in the order of the input, facets in ascending order.
ConvexHull in_input_order(const Points& points, const std::vector<Corner>& corners, Facets facets) {
  std::vector<int> order(corners.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return corners[a].input < corners[b].input; });
  std::vector<int> rank(corners.size());
  ConvexHull hull;
  for (std::size_t i = 0; i < order.size(); ++i) {
    rank[order[i]] = static_cast<int>(i);
    hull.part_vertex.push_back(corners[order[i]].input);
    hull.points.push_back(points[corners[order[i]].input]);
  }
  for (Facet& facet : facets) {
    for (int& vertex : facet) vertex = rank[vertex];
    std::rotate(facet.begin(), std::min_element(facet.begin(), facet.end()), facet.end());
  }
  std::sort(facets.begin(), facets.end());
  hull.facets = std::move(facets);
  return hull;
}

}  // namespace

ConvexHull convex_hull(const Points& points) {
  std::vector<Corner> corners = distinct_corners(points, hull_candidates(points));
  if (corners.size() < 4) {
    throw InputError("only " + std::to_string(corners.size()) +
                     " distinct points, a convex hull needs at least 4 that are not in one plane");
  }
  if (all_in_one_plane(corners)) {
    throw InputError("all points lie in one plane, so their convex hull has no volume");
  }
  Facets facets = hull_facets(corners);
  // A second round over the extreme points alone makes the triangulation of flat sides free of the others.
  while (true) {
    std::vector<Corner> extreme = extreme_corners(corners, facets);
    if (extreme.size() == corners.size()) break;
    corners = std::move(extreme);
    facets = hull_facets(corners);
  }
  Points extreme;
  for (const Corner& corner : corners) extreme.push_back(points[corner.input]);
  // CGAL cuts flat sides into triangles in an order of memory addresses, which change from run to run.
  return in_input_order(points, corners, fan_flat_sides(extreme, facets));
}

Vec3 hull_centre(const ConvexHull& hull) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& p : hull.points) mean += p / static_cast<double>(hull.points.size());
  double volume = 0;
  Vec3 moment = Vec3::Zero();
  for (const auto& [i, j, k] : hull.facets) {
    const Vec3 a = hull.points[i] - mean, b = hull.points[j] - mean, c = hull.points[k] - mean;
    const double six_volumes = a.dot((b - a).cross(c - a));
    volume += six_volumes;
    moment += six_volumes * (a + b + c) / 4;
  }
  for (const Vec3& candidate : {Vec3(mean + moment / volume), mean}) {
    const bool sees_all = std::all_of(hull.facets.begin(), hull.facets.end(), [&](const Facet& f) {
      // Exact: rounding turns the normals of sliver facets anywhere.
      return orientation_sign(candidate, hull.points[f[0]], hull.points[f[1]], hull.points[f[2]]) > 0;
    });
    if (sees_all) return candidate;
  }
  throw ComputationError("the convex hull is too thin to have a point inside in double precision");
}

}  // namespace partwise
