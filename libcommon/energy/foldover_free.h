#pragma once

#include "energy/symmetric_dirichlet.h"

namespace partwise {

/// Regularised energy of a mapped facet that may be turned over, area (|J|^2 + 1 + d^2) / chi(d), with
/// chi(d) = (d + sqrt(d^2 + epsilon^2)) / 2: finite everywhere, and steep enough at folds to undo them
/// (Garanzha et al. 2021). J, d and `height` are those of FacetDistortion.
class FoldoverFree {
 public:
  FoldoverFree(const ReferenceTriangle& reference, double height, double epsilon, const Vec3& p0,
               const Vec3& p1, const Vec3& p2);

  double area_ratio() const { return ratio_; }
  double energy() const { return numerator() / chi_; }

  /// Derivatives with respect to corner 0; the Hessian is the positive part that comes from J alone.
  Vec3 gradient() const;
  Eigen::Matrix3d hessian() const;

  /// With respect to all corners, (x, y, z) of corner 0, 1, 2; the Hessian is positive semidefinite likewise.
  Eigen::Matrix<double, 9, 1> full_gradient() const;
  Eigen::Matrix<double, 9, 9> full_hessian() const;

 private:
  double numerator() const { return dirichlet_ + area_ * (1 + ratio_ * ratio_); }
  double curvature_along_ratio() const;
  Vec3 dirichlet_gradient(int corner) const;
  Vec3 ratio_gradient(int corner) const;

  std::array<Vec3, 3> p_;
  Vec3 cotangents_;
  double area_;
  double scale_;  // 1 / (2 area height)
  double ratio_;
  double dirichlet_;
  double chi_;
  double chi_slope_;
};

}  // namespace partwise
