#include "measure/surface_samples.h"

#include <cmath>
#include <numeric>
#include <vector>

#include "geometry/normals.h"

namespace partwise {
namespace {

/// SplitMix64: a bijective hash whose values over consecutive integers pass as random.
std::uint64_t hashed(std::uint64_t key) {
  key += 0x9e3779b97f4a7c15ULL;
  key = (key ^ (key >> 30)) * 0xbf58476d1ce4e5b9ULL;
  key = (key ^ (key >> 27)) * 0x94d049bb133111ebULL;
  return key ^ (key >> 31);
}

/// Random number in [0, 1), the `index`th of a sequence.
double uniform(std::uint64_t seed, std::uint64_t index) {
  return static_cast<double>(hashed(hashed(seed) ^ index) >> 11) * 0x1p-53;
}

Vec3 point_in_triangle(const Vec3& a, const Vec3& b, const Vec3& c, double u, double v) {
  const double root = std::sqrt(u);
  return a + root * (1 - v) * (b - a) + root * v * (c - a);
}

}  // namespace

Points sample_surface(const Points& points, const Facets& facets, int count, std::uint64_t seed) {
  std::vector<double> area_up_to = facet_areas(points, facets);
  std::partial_sum(area_up_to.begin(), area_up_to.end(), area_up_to.begin());
  Points samples;
  if (area_up_to.empty() || !(area_up_to.back() > 0)) return samples;
  samples.reserve(count);
  std::size_t f = 0;
  for (int i = 0; i < count; ++i) {
    const auto first = 3 * static_cast<std::uint64_t>(i);
    const double at = area_up_to.back() * ((i + uniform(seed, first)) / count);
    while (f + 1 < facets.size() && area_up_to[f] <= at) ++f;
    const auto& [a, b, c] = facets[f];
    samples.push_back(point_in_triangle(points[a], points[b], points[c], uniform(seed, first + 1),
                                        uniform(seed, first + 2)));
  }
  return samples;
}

}  // namespace partwise
