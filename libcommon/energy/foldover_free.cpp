#include "energy/foldover_free.h"

#include <cmath>

namespace partwise {

FoldoverFree::FoldoverFree(const ReferenceTriangle& reference, double height, double epsilon, const Vec3& p0,
                           const Vec3& p1, const Vec3& p2)
    : area_(reference.area), cotangents_(reference.cotangents[1] + reference.cotangents[2]) {
  const double scale = 1 / (2 * area_ * height);
  const Vec3& cot = reference.cotangents;
  ratio_ = scale * p0.dot((p1 - p0).cross(p2 - p0));
  ratio_gradient_ = scale * p1.cross(p2);
  dirichlet_ = 0.5 * (cot[0] * (p1 - p2).squaredNorm() + cot[1] * (p2 - p0).squaredNorm() +
                      cot[2] * (p0 - p1).squaredNorm());
  dirichlet_gradient_ = cot[2] * (p0 - p1) + cot[1] * (p0 - p2);
  const double root = std::sqrt(ratio_ * ratio_ + epsilon * epsilon);
  // For large negative ratios the sum cancels; the quotient does not.
  chi_ = ratio_ > 0 ? (ratio_ + root) / 2 : epsilon * epsilon / (2 * (root - ratio_));
  chi_slope_ = chi_ / root;
}

Vec3 FoldoverFree::gradient() const {
  const Vec3 rise = dirichlet_gradient_ + 2 * area_ * ratio_ * ratio_gradient_;
  return rise / chi_ - numerator() * chi_slope_ / (chi_ * chi_) * ratio_gradient_;
}

Eigen::Matrix3d FoldoverFree::hessian() const {
  // Along the ratio's gradient f(d) = numerator / chi is convex where it matters; its curvature is taken as
  // that of the quotient with the mixed terms left out.
  const double along = 2 * area_ / chi_ + 2 * numerator() * chi_slope_ * chi_slope_ / (chi_ * chi_ * chi_);
  Eigen::Matrix3d hessian = along * ratio_gradient_ * ratio_gradient_.transpose();
  hessian.diagonal().array() += std::max(cotangents_, 0.0) / chi_;
  return hessian;
}

}  // namespace partwise
