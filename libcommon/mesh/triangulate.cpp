#include "mesh/triangulate.h"

namespace partwise {
namespace {

/// Twice the vector area of the polygon (Newell), relative to its first corner.
Vec3 polygon_normal(const Points& points, const std::vector<int>& corners) {
  Vec3 normal = Vec3::Zero();
  const Vec3& origin = points[corners[0]];
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    normal += (points[corners[i]] - origin).cross(points[corners[i + 1]] - origin);
  }
  return normal.stableNormalized();
}

class Ear {
 public:
  Ear(const Points& points, const std::vector<int>& corners, std::size_t tip, const Vec3& normal)
      : a_(points[corners[(tip + corners.size() - 1) % corners.size()]]),
        b_(points[corners[tip]]),
        c_(points[corners[(tip + 1) % corners.size()]]),
        normal_(normal) {}

  double signed_area(const Vec3& u, const Vec3& v, const Vec3& w) const {
    return (v - u).cross(w - u).dot(normal_);
  }
  bool contains(const Vec3& p) const {
    return signed_area(a_, b_, p) >= 0 && signed_area(b_, c_, p) >= 0 && signed_area(c_, a_, p) >= 0;
  }
  bool convex() const { return signed_area(a_, b_, c_) > 0; }
  /// Area over squared edge lengths: largest for equilateral triangles.
  double quality() const {
    const double edges = (b_ - a_).squaredNorm() + (c_ - b_).squaredNorm() + (a_ - c_).squaredNorm();
    return edges > 0 ? signed_area(a_, b_, c_) / edges : 0;
  }

 private:
  const Vec3 &a_, &b_, &c_, &normal_;
};

bool is_ear(const Points& points, const std::vector<int>& corners, std::size_t tip, const Vec3& normal) {
  const Ear ear(points, corners, tip, normal);
  if (!ear.convex()) return false;
  const std::size_t n = corners.size();
  for (std::size_t k = 2; k + 1 < n; ++k) {
    const int other = corners[(tip + k) % n];
    if (other != corners[(tip + 1) % n] && other != corners[(tip + n - 1) % n] &&
        ear.contains(points[other])) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::vector<Facet> triangulate_polygon(const Points& points, std::vector<int> corners) {
  const Vec3 normal = polygon_normal(points, corners);
  std::vector<Facet> facets;
  while (corners.size() > 3) {
    std::size_t best = 1;  // for polygons that have no ear, which are not simple
    double best_quality = -1;
    for (std::size_t tip = 0; tip < corners.size(); ++tip) {
      if (!is_ear(points, corners, tip, normal)) continue;
      double quality = Ear(points, corners, tip, normal).quality();
      // Of a quadrangle the other triangle counts as well.
      if (corners.size() == 4) {
        quality = std::min(quality, Ear(points, corners, (tip + 2) % 4, normal).quality());
      }
      if (quality > best_quality) {
        best_quality = quality;
        best = tip;
      }
    }
    const std::size_t n = corners.size();
    facets.push_back({corners[(best + n - 1) % n], corners[best], corners[(best + 1) % n]});
    corners.erase(corners.begin() + static_cast<long>(best));
  }
  facets.push_back({corners[0], corners[1], corners[2]});
  return facets;
}

}  // namespace partwise
