#pragma once

#include "mapping/domains.h"

namespace partwise {

/// A convex hull seen from an interior point: every direction meets it once, so the hull and the sphere of
/// directions are the same domain. Positions are relative to that point (the origin here).
class StarHull {
 public:
  /// Where a direction meets the hull.
  struct Place {
    int facet = 0;
    Vec3 position = Vec3::Zero();
  };

  /// \pre centre lies strictly inside the hull
  StarHull(const ConvexHull& hull, const Vec3& centre);

  /// The point of the hull in a direction (any length > 0), found by walking from `hint` over the hull's
  /// facets.
  Place project(const Vec3& direction, int hint) const;

  /// The places of directions that are given in the order of a mesh's vertices, so that neighbours come close
  /// together.
  std::vector<Place> project(const Points& directions) const;

  const Vec3& normal(int facet) const { return normals_[facet]; }  ///< unit, outward
  double height(int facet) const { return heights_[facet]; }  ///< distance of the facet's plane to the origin
  double area() const { return area_; }
  /// Mean of p p^T over the hull's surface: unlike that over its vertices, it hardly changes with which
  /// points of a flat side count as extreme.
  Eigen::Matrix3d second_moments() const;

 private:
  Points points_;
  Facets facets_;
  Points normals_;
  std::vector<double> heights_;
  std::vector<Facet> neighbours_;  // per facet, across the edge from corner i to i + 1
  double area_ = 0;
};

}  // namespace partwise
