#pragma once

#include <Eigen/Dense>

#include <vector>

#include "mapping/star_hull.h"
#include "mapping/star_surface.h"

namespace partwise {

/// A convex hull with its edges and corners rounded off: twice continuously differentiable, convex, inside
/// the hull, and equal to it away from its edges. Newton's method needs such a surface: on the hull itself
/// the vertices that cross an edge spoil its steps.
///
/// The hull's gauge function (1 on the hull, linear along rays) is smoothed by a cubic B-spline on a lattice,
/// which reproduces the gauge wherever it is linear. The lattice is that of the hull's principal axes, scaled
/// to its extents, so that the result turns and scales with the hull. Positions are relative to the hull's
/// centre.
class SmoothHull : public StarSurface {
 public:
  /// `spacing` of the lattice, the hull's mean radius being 1: edges are rounded over about twice that.
  SmoothHull(const StarHull& hull, double spacing);

  /// Of the gauge at a position.
  struct Gauge {
    double value = 0;
    Vec3 gradient = Vec3::Zero();
    Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
  };
  Gauge gauge(const Vec3& position) const;

  Place project(const Vec3& direction) const override;

 private:
  std::size_t node(int i, int j, int k) const {
    return (static_cast<std::size_t>(i) * count_ + static_cast<std::size_t>(j)) * count_ +
           static_cast<std::size_t>(k);
  }

  double spacing_;
  int count_ = 0;               ///< nodes along an axis; node i is at (i - (count_ - 1) / 2) spacing_
  Eigen::Matrix3d to_lattice_;  ///< from positions to where the hull is about the unit sphere
  std::vector<double> values_;  ///< of the gauge at the nodes near the unit sphere
};

}  // namespace partwise
