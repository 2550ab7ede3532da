#include "energy/foldover_free.h"

#include <cmath>

namespace partwise {

FoldoverFree::FoldoverFree(const ReferenceTriangle& reference, double height, double epsilon, const Vec3& p0,
                           const Vec3& p1, const Vec3& p2)
    : p_{p0, p1, p2},
      cotangents_(reference.cotangents),
      area_(reference.area),
      scale_(1 / (2 * area_ * height)) {
  ratio_ = scale_ * p0.dot((p1 - p0).cross(p2 - p0));
  dirichlet_ = 0.5 * (cotangents_[0] * (p1 - p2).squaredNorm() + cotangents_[1] * (p2 - p0).squaredNorm() +
                      cotangents_[2] * (p0 - p1).squaredNorm());
  const double root = std::sqrt(ratio_ * ratio_ + epsilon * epsilon);
  // For large negative ratios the sum cancels; the quotient does not.
  chi_ = ratio_ > 0 ? (ratio_ + root) / 2 : epsilon * epsilon / (2 * (root - ratio_));
  chi_slope_ = chi_ / root;
}

Vec3 FoldoverFree::dirichlet_gradient(int corner) const {
  const int next = (corner + 1) % 3, previous = (corner + 2) % 3;
  return cotangents_[previous] * (p_[corner] - p_[next]) + cotangents_[next] * (p_[corner] - p_[previous]);
}

Vec3 FoldoverFree::ratio_gradient(int corner) const {
  return scale_ * p_[(corner + 1) % 3].cross(p_[(corner + 2) % 3]);
}

double FoldoverFree::curvature_along_ratio() const {
  // Along the ratio's gradient f(d) = numerator / chi is convex where it matters; its curvature is taken as
  // that of the quotient with the mixed terms left out.
  return 2 * area_ / chi_ + 2 * numerator() * chi_slope_ * chi_slope_ / (chi_ * chi_ * chi_);
}

Vec3 FoldoverFree::gradient() const {
  const Vec3 ratio = ratio_gradient(0);
  const Vec3 rise = dirichlet_gradient(0) + 2 * area_ * ratio_ * ratio;
  return rise / chi_ - numerator() * chi_slope_ / (chi_ * chi_) * ratio;
}

Eigen::Matrix3d FoldoverFree::hessian() const {
  const Vec3 ratio = ratio_gradient(0);
  Eigen::Matrix3d hessian = curvature_along_ratio() * ratio * ratio.transpose();
  hessian.diagonal().array() += std::max(cotangents_[1] + cotangents_[2], 0.0) / chi_;
  return hessian;
}

Eigen::Matrix<double, 9, 1> FoldoverFree::full_gradient() const {
  const double along = 2 * area_ * ratio_ / chi_ - numerator() * chi_slope_ / (chi_ * chi_);
  Eigen::Matrix<double, 9, 1> gradient;
  for (int i = 0; i < 3; ++i) {
    gradient.segment<3>(3 * i) = dirichlet_gradient(i) / chi_ + along * ratio_gradient(i);
  }
  return gradient;
}

Eigen::Matrix<double, 9, 9> FoldoverFree::full_hessian() const {
  Eigen::Matrix<double, 9, 1> ratio;
  for (int i = 0; i < 3; ++i) ratio.segment<3>(3 * i) = ratio_gradient(i);
  Eigen::Matrix<double, 9, 9> hessian = curvature_along_ratio() * ratio * ratio.transpose();
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    hessian.block<3, 3>(3 * i, 3 * i).diagonal().array() += (cotangents_[j] + cotangents_[k]) / chi_;
    hessian.block<3, 3>(3 * i, 3 * j).diagonal().array() -= cotangents_[k] / chi_;
    hessian.block<3, 3>(3 * j, 3 * i).diagonal().array() -= cotangents_[k] / chi_;
  }
  return hessian;
}

}  // namespace partwise
