#pragma once

#include "mesh/types.h"

namespace partwise {

/// A facet as it is before it is mapped, up to rigid motion: what distortion is measured against.
struct ReferenceTriangle {
  Vec3 cotangents;  ///< of the angle at each corner
  double area = 0;

  /// From the facet's corners. A facet flatter than `least_quality` (4 sqrt(3) area / sum of squared edges, 1
  /// for an equilateral one) becomes equilateral of the same area, but not less than `least_area`.
  static ReferenceTriangle from(const Vec3& a, const Vec3& b, const Vec3& c, double least_quality,
                                double least_area);
};

/// Symmetric Dirichlet energy of a mapped facet, area (|J|^2 + |J^-1|^2) = D (1 + 1 / d^2), with the
/// Dirichlet term D = 1/2 sum cot |edge|^2 and the area ratio d = det(p0, p1, p2) / (2 area height).
///
/// `height` is the distance from the origin to the surface that the facet is mapped onto: det / height is
/// twice the signed area of the facet's image, positive when it is seen from the origin with its inside
/// facing it. Smith and Schaefer 2015, here for maps onto surfaces that are star-shaped about the origin.
class FacetDistortion {
 public:
  FacetDistortion(const ReferenceTriangle& reference, double height, const Vec3& p0, const Vec3& p1,
                  const Vec3& p2);

  double area_ratio() const { return ratio_; }
  /// Infinite when the facet is not positively oriented.
  double energy() const;

  /// Derivative with respect to the logarithm of `height`.
  double log_height_slope() const { return 2 * dirichlet_ / (ratio_ * ratio_); }
  /// Derivatives of that slope with respect to all corners.
  Eigen::Matrix<double, 9, 1> log_height_slope_gradient() const;

  /// Derivatives with respect to corner 0 alone: what a vertex-wise method needs.
  Vec3 gradient() const;
  Eigen::Matrix3d hessian() const;

  /// Derivatives with respect to all corners, (x, y, z) of corner 0, 1, 2.
  Eigen::Matrix<double, 9, 1> full_gradient() const;
  Eigen::Matrix<double, 9, 9> full_hessian() const;

 private:
  Vec3 dirichlet_gradient(int corner) const;
  Vec3 ratio_gradient(int corner) const;

  std::array<Vec3, 3> p_;
  Vec3 cotangents_;
  double scale_;  // 1 / (2 area height)
  double ratio_;
  double dirichlet_;
};

}  // namespace partwise
