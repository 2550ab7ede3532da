#include "geometry/hull_candidates.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "error.h"
#include "geometry/convex_hull.h"
#include "geometry/normals.h"
#include "mesh/tri_mesh.h"

namespace partwise {
namespace {

constexpr std::size_t kFewPoints = 200;  // below, to sort points out takes longer than it spares
constexpr double kThinnest = 1e-4;       // height over longest edge of a facet whose plane is sharp enough
constexpr double kClearlyInside = 1e-7;  // over the diagonal; rounding moves a plane by far less

/// Extreme points in both senses of 13 directions.
Points extreme_points(const Points& points) {
  std::vector<int> extreme;
  for (int code = 14; code < 27; ++code) {  // the digits to base 3, less 1: one of each pair of opposites
    const Vec3 direction(code / 9 - 1, code / 3 % 3 - 1, code % 3 - 1);
    const auto [least, most] = std::minmax_element(
        points.begin(), points.end(),
        [&](const Vec3& a, const Vec3& b) { return direction.dot(a) < direction.dot(b); });
    extreme.push_back(static_cast<int>(least - points.begin()));
    extreme.push_back(static_cast<int>(most - points.begin()));
  }
  Points result;
  for (const int i : extreme) result.push_back(points[i]);
  return result;
}

struct Side {
  Vec3 corner, normal;  // unit, outward
};

/// The sides of a hull; none when one is too thin to tell in double precision.
std::optional<std::vector<Side>> sides_of(const ConvexHull& hull) {
  std::vector<Side> sides;
  for (const auto& [i, j, k] : hull.facets) {
    const Vec3 &a = hull.points[i], &b = hull.points[j], &c = hull.points[k];
    const Vec3 vector = area_vector(a, b, c);
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    if (!(vector.norm() > kThinnest * longest)) return std::nullopt;
    sides.push_back({a, vector.stableNormalized()});
  }
  return sides;
}

std::optional<std::vector<Side>> sides_of_extremes(const Points& points) {
  if (points.size() < kFewPoints) return std::nullopt;
  try {
    return sides_of(convex_hull(extreme_points(points)));
  } catch (const InputError&) {
    return std::nullopt;  // flat
  }
}

}  // namespace

std::vector<int> hull_candidates(const Points& points) {
  std::vector<int> candidates(points.size());
  std::iota(candidates.begin(), candidates.end(), 0);
  const auto sides = sides_of_extremes(points);
  if (!sides) return candidates;
  const double margin = kClearlyInside * bounding_box_diagonal(points);
  std::erase_if(candidates, [&](int i) {
    return std::all_of(sides->begin(), sides->end(),
                       [&](const Side& side) { return side.normal.dot(side.corner - points[i]) > margin; });
  });
  return candidates;
}

}  // namespace partwise
