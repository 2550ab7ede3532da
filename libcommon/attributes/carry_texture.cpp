#include "attributes/carry_texture.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <map>
#include <set>

#include "geometry/triangle_queries.h"
#include "mapping/parallel_parts.h"
#include "mesh/surface_walk.h"

namespace partwise {
namespace {

using Place = Eigen::Vector2d;

constexpr int kFacetsAtOnce = 256;

class TextureSource {
 public:
  TextureSource(const TextureCorners& given, const TriMesh& giver)
      : given_(given), giver_(giver), walker_(giver) {}

  Place at(const SurfacePoint& point) const {
    Place sum = Place::Zero();
    for (int i = 0; i < 3; ++i) sum += point.barycentric[i] * given_.place(point.facet, i);
    return sum;
  }

  /// Facets around `start` that are joined to it without a seam and have a corner within `reach` of it.
  std::vector<int> region(int start, double reach) const {
    const Vec3 middle = position(giver_, {start, Vec3::Constant(1.0 / 3)});
    std::set<int> found{start};
    std::deque<int> open{start};
    while (!open.empty()) {
      const int facet = open.front();
      open.pop_front();
      for (int i = 0; i < 3; ++i) {
        const int next = walker_.neighbour(facet, i);
        if (next < 0 || found.count(next) > 0 || is_seam(facet, i, next) || !is_near(next, middle, reach)) {
          continue;
        }
        found.insert(next);
        open.push_back(next);
      }
    }
    return {found.begin(), found.end()};
  }

  /// The texture's place at `origin`, or where the region is nearest to it.
  Place in_region(const std::vector<int>& region, const SurfacePoint& origin) const {
    SurfacePoint best;
    double least = std::numeric_limits<double>::max();
    const Vec3 query = position(giver_, origin);
    for (const int facet : region) {
      const SurfacePoint same = seen_from(giver_, origin, facet);
      if (same.facet >= 0) return at(same);
      const Facet& f = giver_.facet(facet);
      const auto near =
          closest_on_triangle(query, giver_.point(f[0]), giver_.point(f[1]), giver_.point(f[2]));
      if (near.squared_distance >= least) continue;
      least = near.squared_distance;
      best = {facet, near.barycentric};
    }
    return at(best);
  }

  const TriMesh& mesh() const { return giver_; }

 private:
  bool is_near(int facet, const Vec3& middle, double reach) const {
    for (const int v : giver_.facet(facet)) {
      if ((giver_.point(v) - middle).norm() <= reach) return true;
    }
    return false;
  }

  bool is_seam(int facet, int edge, int neighbour) const {
    if (!given_.images.empty() && given_.images[facet] != given_.images[neighbour]) return true;
    for (const int i : {edge, (edge + 1) % 3}) {
      const Facet& other = giver_.facet(neighbour);
      const auto j = std::find(other.begin(), other.end(), giver_.facet(facet)[i]) - other.begin();
      if ((given_.place(facet, i) - given_.place(neighbour, static_cast<int>(j))).norm() > kTextureJump)
        return true;
    }
    return false;
  }

  const TextureCorners& given_;
  const TriMesh& giver_;
  SurfaceWalker walker_;
};

/// The facet that most samples lie in, the first of equals.
int most_frequent(const std::vector<SurfacePoint>& samples) {
  std::map<int, int> counts;
  for (const SurfacePoint& sample : samples) ++counts[sample.facet];
  return std::max_element(counts.begin(), counts.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

}  // namespace

TextureCorners carry_texture(const TextureCorners& given, const TriMesh& giver, const TriMesh& receiver,
                             const Origins& origins) {
  const TextureSource texture(given, giver);
  const int count = receiver.facet_count();
  TextureCorners carried;
  carried.places.resize(count);
  if (!given.images.empty()) carried.images.resize(count);
  for_each_part((count + kFacetsAtOnce - 1) / kFacetsAtOnce, [&](int block) {
    for (int f = block * kFacetsAtOnce; f < std::min(count, (block + 1) * kFacetsAtOnce); ++f) {
      const int start = most_frequent(origins.facets[f]);
      const Vec3 middle = position(giver, {start, Vec3::Constant(1.0 / 3)});
      double reach = 0;
      for (const int v : receiver.facet(f)) {
        reach = std::max(reach, (position(giver, origins.vertices[v]) - middle).norm());
      }
      const std::vector<int> region = texture.region(start, 1.5 * reach);
      for (int i = 0; i < 3; ++i) {
        const Place place = texture.in_region(region, origins.vertices[receiver.facet(f)[i]]);
        carried.places[f][2 * i] = place.x();
        carried.places[f][2 * i + 1] = place.y();
      }
      if (!given.images.empty()) carried.images[f] = given.images[start];
    }
  });
  return carried;
}

}  // namespace partwise
