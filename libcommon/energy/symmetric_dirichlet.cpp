#include "energy/symmetric_dirichlet.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace partwise {
namespace {

Eigen::Matrix3d cross_matrix(const Vec3& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

}  // namespace

ReferenceTriangle ReferenceTriangle::from(const Vec3& a, const Vec3& b, const Vec3& c, double least_quality,
                                          double least_area) {
  const Vec3 ab = b - a, bc = c - b, ca = a - c;
  const double area = ab.cross(-ca).norm() / 2;
  const double squares = ab.squaredNorm() + bc.squaredNorm() + ca.squaredNorm();
  if (area < least_area || 4 * std::sqrt(3.0) * area < least_quality * squares) {
    return {Vec3::Constant(1 / std::sqrt(3.0)), std::max(area, least_area)};
  }
  return {Vec3(-ab.dot(ca), -ab.dot(bc), -bc.dot(ca)) / (2 * area), area};
}

FacetDistortion::FacetDistortion(const ReferenceTriangle& reference, double height, const Vec3& p0,
                                 const Vec3& p1, const Vec3& p2)
    : p_{p0, p1, p2}, cotangents_(reference.cotangents), scale_(1 / (2 * reference.area * height)) {
  // The difference form: far more accurate for facets that are small against their distance from the origin.
  ratio_ = scale_ * p0.dot((p1 - p0).cross(p2 - p0));
  dirichlet_ = 0.5 * (cotangents_[0] * (p1 - p2).squaredNorm() + cotangents_[1] * (p2 - p0).squaredNorm() +
                      cotangents_[2] * (p0 - p1).squaredNorm());
}

double FacetDistortion::energy() const {
  if (!(ratio_ > 0)) return std::numeric_limits<double>::infinity();
  return dirichlet_ * (1 + 1 / (ratio_ * ratio_));
}

Vec3 FacetDistortion::dirichlet_gradient(int corner) const {
  const int next = (corner + 1) % 3, previous = (corner + 2) % 3;
  return cotangents_[previous] * (p_[corner] - p_[next]) + cotangents_[next] * (p_[corner] - p_[previous]);
}

Vec3 FacetDistortion::ratio_gradient(int corner) const {
  return scale_ * p_[(corner + 1) % 3].cross(p_[(corner + 2) % 3]);
}

Vec3 FacetDistortion::gradient() const {
  const double inverse = 1 / ratio_;
  return (1 + inverse * inverse) * dirichlet_gradient(0) -
         2 * dirichlet_ * inverse * inverse * inverse * ratio_gradient(0);
}

Eigen::Matrix3d FacetDistortion::hessian() const {
  const double inverse = 1 / ratio_, cubed = inverse * inverse * inverse;
  const Vec3 dirichlet = dirichlet_gradient(0), ratio = ratio_gradient(0);
  const Eigen::Matrix3d mixed = dirichlet * ratio.transpose();
  Eigen::Matrix3d hessian =
      -2 * cubed * (mixed + mixed.transpose()) + 6 * dirichlet_ * cubed * inverse * ratio * ratio.transpose();
  hessian.diagonal().array() += (1 + inverse * inverse) * (cotangents_[1] + cotangents_[2]);
  return hessian;
}

Eigen::Matrix<double, 9, 1> FacetDistortion::full_gradient() const {
  const double inverse = 1 / ratio_;
  Eigen::Matrix<double, 9, 1> gradient;
  for (int i = 0; i < 3; ++i) {
    gradient.segment<3>(3 * i) = (1 + inverse * inverse) * dirichlet_gradient(i) -
                                 2 * dirichlet_ * inverse * inverse * inverse * ratio_gradient(i);
  }
  return gradient;
}

Eigen::Matrix<double, 9, 1> FacetDistortion::log_height_slope_gradient() const {
  const double inverse = 1 / ratio_, squared = inverse * inverse;
  Eigen::Matrix<double, 9, 1> gradient;
  for (int i = 0; i < 3; ++i) {
    gradient.segment<3>(3 * i) =
        2 * squared * dirichlet_gradient(i) - 4 * dirichlet_ * squared * inverse * ratio_gradient(i);
  }
  return gradient;
}

Eigen::Matrix<double, 9, 9> FacetDistortion::full_hessian() const {
  const double inverse = 1 / ratio_, cubed = inverse * inverse * inverse;
  Eigen::Matrix<double, 9, 1> dirichlet, ratio;
  for (int i = 0; i < 3; ++i) {
    dirichlet.segment<3>(3 * i) = dirichlet_gradient(i);
    ratio.segment<3>(3 * i) = ratio_gradient(i);
  }
  Eigen::Matrix<double, 9, 9> hessian =
      -2 * cubed * (dirichlet * ratio.transpose() + ratio * dirichlet.transpose()) +
      6 * dirichlet_ * cubed * inverse * ratio * ratio.transpose();
  const double stretch = 1 + inverse * inverse;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    hessian.block<3, 3>(3 * i, 3 * i).diagonal().array() += stretch * (cotangents_[j] + cotangents_[k]);
    // det(p_i, p_j, p_k) has the mixed derivative -[p_k]x in (p_i, p_j).
    Eigen::Matrix3d mixed = 2 * dirichlet_ * cubed * scale_ * cross_matrix(p_[k]);
    mixed.diagonal().array() -= stretch * cotangents_[k];
    hessian.block<3, 3>(3 * i, 3 * j) += mixed;
    hessian.block<3, 3>(3 * j, 3 * i) += mixed.transpose();
  }
  return hessian;
}

}  // namespace partwise
