#include "mapping/smooth_hull.h"

#include <Eigen/Eigenvalues>

#include <array>
#include <cmath>

namespace partwise {
namespace {

/// Uniform cubic B-spline at a fraction between nodes: weights of the four nodes around, and their
/// derivatives.
struct SplineWeights {
  std::array<double, 4> value, slope, bend;

  explicit SplineWeights(double t) {
    const double u = 1 - t;
    value = {u * u * u / 6, (4 - 6 * t * t + 3 * t * t * t) / 6, (4 - 6 * u * u + 3 * u * u * u) / 6,
             t * t * t / 6};
    slope = {-u * u / 2, (3 * t - 4) * t / 2, (4 - 3 * u) * u / 2, t * t / 2};
    bend = {u, 3 * t - 2, 3 * u - 2, t};
  }
};

/// The nodes around a point, 4 x 4 x 4, by their first, and their weights along each axis.
struct Cell {
  std::array<int, 3> first;
  std::array<SplineWeights, 3> weights;
};

Cell cell_around(const Vec3& at) {
  const Vec3 below = at.array().floor();
  const Vec3 t = at - below;
  return {{static_cast<int>(below.x()) - 1, static_cast<int>(below.y()) - 1, static_cast<int>(below.z()) - 1},
          {SplineWeights(t.x()), SplineWeights(t.y()), SplineWeights(t.z())}};
}

}  // namespace

SmoothHull::SmoothHull(const StarHull& hull, double spacing) : spacing_(spacing) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(hull.second_moments());
  const Vec3 radii = (3 * axes.eigenvalues()).cwiseSqrt();
  to_lattice_ = radii.cwiseInverse().asDiagonal() * axes.eigenvectors().transpose();
  const Eigen::Matrix3d from_lattice = axes.eigenvectors() * radii.asDiagonal();

  const int half = static_cast<int>(std::ceil(1 / spacing)) + 2;
  count_ = 2 * half + 1;
  values_.assign(static_cast<std::size_t>(count_) * count_ * count_, 0);
  const double near = 2 * std::sqrt(3.0) * spacing;
  int hint = 0;
  for (int i = 0; i < count_; ++i) {
    for (int j = 0; j < count_; ++j) {
      for (int k = 0; k < count_; ++k) {
        const Vec3 position = spacing * Vec3(i - half, j - half, k - half);
        if (std::abs(position.norm() - 1) > near || position.isZero(0)) continue;
        const Vec3 direction = from_lattice * position;
        const StarHull::Place place = hull.project(direction, hint);
        hint = place.facet;
        values_[node(i, j, k)] = hull.normal(hint).dot(direction) / hull.height(hint);
      }
    }
  }
}

SmoothHull::Place SmoothHull::project(const Vec3& direction) const {
  const Vec3 x = to_lattice_ * direction;
  const double r = x.norm();
  const Vec3 u = x / r;
  const Cell cell = cell_around(u / spacing_ + Vec3::Constant((count_ - 1) / 2));
  double value = 0;
  Vec3 slope = Vec3::Zero();
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const double* row = &values_[node(cell.first[0] + i, cell.first[1] + j, cell.first[2])];
      const auto& [wi, wj, wk] = cell.weights;
      double v = 0, s = 0;
      for (int k = 0; k < 4; ++k) {
        v += wk.value[k] * row[k];
        s += wk.slope[k] * row[k];
      }
      value += wi.value[i] * wj.value[j] * v;
      slope +=
          Vec3(wi.slope[i] * wj.value[j] * v, wi.value[i] * wj.slope[j] * v, wi.value[i] * wj.value[j] * s);
    }
  }
  slope /= spacing_;
  const Vec3 gradient = to_lattice_.transpose() * (value * u + slope - u.dot(slope) * u);
  const double steepness = gradient.norm();
  return {direction / (r * value), gradient / steepness, 1 / steepness};
}

SmoothHull::Gauge SmoothHull::gauge(const Vec3& position) const {
  const Vec3 x = to_lattice_ * position;
  const double r = x.norm();
  const Vec3 u = x / r;
  const Cell cell = cell_around(u / spacing_ + Vec3::Constant((count_ - 1) / 2));
  const auto& [x_weights, y_weights, z_weights] = cell.weights;
  double value = 0;
  Vec3 slope = Vec3::Zero();
  Eigen::Matrix3d bend = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const double* row = &values_[node(cell.first[0] + i, cell.first[1] + j, cell.first[2])];
      double v = 0, s = 0, b = 0;
      for (int k = 0; k < 4; ++k) {
        v += z_weights.value[k] * row[k];
        s += z_weights.slope[k] * row[k];
        b += z_weights.bend[k] * row[k];
      }
      const double wi = x_weights.value[i], wj = y_weights.value[j];
      const double di = x_weights.slope[i], dj = y_weights.slope[j];
      value += wi * wj * v;
      slope += Vec3(di * wj * v, wi * dj * v, wi * wj * s);
      bend(0, 0) += x_weights.bend[i] * wj * v;
      bend(1, 1) += wi * y_weights.bend[j] * v;
      bend(2, 2) += wi * wj * b;
      bend(0, 1) += di * dj * v;
      bend(0, 2) += di * wj * s;
      bend(1, 2) += wi * dj * s;
    }
  }
  slope /= spacing_;
  bend /= spacing_ * spacing_;
  bend.triangularView<Eigen::StrictlyLower>() = bend.transpose();
  // Of r S(x / r), S being what was summed.
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - u * u.transpose();
  bend.diagonal().array() += value - u.dot(slope);
  Gauge result;
  result.value = r * value;
  result.gradient = to_lattice_.transpose() * (value * u + across * slope);
  result.hessian = to_lattice_.transpose() * (across * bend * across / r) * to_lattice_;
  return result;
}

}  // namespace partwise
