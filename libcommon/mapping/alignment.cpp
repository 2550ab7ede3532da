#include "mapping/alignment.h"

#include <Eigen/LU>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>

namespace partwise {
namespace {

/// Below this ratio of the second to the first singular value, points count as collinear.
constexpr double kCollinear = 0.01;

/// Rotation part of a linear map with positive determinant.
Eigen::Matrix3d closest_rotation(const Eigen::Matrix3d& covariance) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Vec3 signs = Vec3::Ones();
  if (svd.matrixU().determinant() * svd.matrixV().determinant() < 0) signs[2] = -1;
  return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

/// Rotation for sum w y x^T; collinear or missing points are completed by the prior's rotation.
Eigen::Matrix3d completed_rotation(const Eigen::Matrix3d& covariance, const Eigen::Matrix3d& prior,
                                   double prior_weight = 0) {
  const Vec3 values = Eigen::JacobiSVD<Eigen::Matrix3d>(covariance).singularValues();
  if (values[0] <= 0) return prior;
  if (prior_weight > 0) return closest_rotation(covariance + prior_weight * values[0] * prior);
  if (values[1] >= kCollinear * values[0]) return closest_rotation(covariance);
  return closest_rotation(covariance + 2 * kCollinear * values[0] * prior);
}

struct Moments {
  double weight = 0;
  Vec3 source_mean = Vec3::Zero(), target_mean = Vec3::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< sum w y x^T
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();      ///< sum w x x^T
};

void accumulate(Moments& moments, const MatchedPoints& matched, const Vec3& source_centre,
                const Vec3& target_centre) {
  for (std::size_t i = 0; i < matched.source.size(); ++i) {
    const Vec3 x = matched.source[i] - source_centre, y = matched.target[i] - target_centre;
    moments.covariance += matched.weights[i] * y * x.transpose();
    moments.spread += matched.weights[i] * x * x.transpose();
    moments.weight += matched.weights[i];
  }
}

Moments central_moments(const MatchedPoints& matched) {
  Moments moments;
  double weight = 0;
  for (std::size_t i = 0; i < matched.source.size(); ++i) {
    moments.source_mean += matched.weights[i] * matched.source[i];
    moments.target_mean += matched.weights[i] * matched.target[i];
    weight += matched.weights[i];
  }
  if (weight > 0) {
    moments.source_mean /= weight;
    moments.target_mean /= weight;
  }
  accumulate(moments, matched, moments.source_mean, moments.target_mean);
  return moments;
}

}  // namespace

void MatchedPoints::add(const Vec3& source_point, const Vec3& target_point, double weight) {
  source.push_back(source_point);
  target.push_back(target_point);
  weights.push_back(weight);
}

Eigen::Affine3d fit_similarity(const MatchedPoints& matched, const Eigen::Affine3d& prior) {
  const Moments moments = central_moments(matched);
  if (moments.weight <= 0) return prior;
  const double prior_scale = std::cbrt(prior.linear().determinant());
  const Eigen::Matrix3d rotation = completed_rotation(moments.covariance, prior.linear() / prior_scale);
  const double variance = moments.spread.trace();
  const double overlap = (rotation.transpose() * moments.covariance).trace();
  const double scale = variance > 0 && overlap > 0 ? overlap / variance : prior_scale;
  Eigen::Affine3d result = Eigen::Affine3d::Identity();
  result.linear() = scale * rotation;
  result.translation() = moments.target_mean - result.linear() * moments.source_mean;
  return result;
}

Eigen::Matrix3d fit_linear(const MatchedPoints& matched, const Vec3& source_centre, const Vec3& target_centre,
                           const Eigen::Matrix3d& prior, double stiffness) {
  Moments moments;
  accumulate(moments, matched, source_centre, target_centre);
  const double variance = moments.spread.trace();
  if (variance <= 0) return prior;
  const double pull = stiffness * variance / 3;
  const Eigen::Matrix3d normal = moments.spread + pull * Eigen::Matrix3d::Identity();
  // A normal = covariance + pull * prior, solved from the right; written as a correction of the prior so that
  // an exact prior stays exact.
  const Eigen::Matrix3d residual = moments.covariance - prior * moments.spread;
  return prior + residual * normal.inverse();
}

Eigen::Matrix3d fit_rotation(const MatchedPoints& matched, const Vec3& source_centre,
                             const Vec3& target_centre, const Eigen::Matrix3d& prior, double prior_weight) {
  Moments moments;
  accumulate(moments, matched, source_centre, target_centre);
  return completed_rotation(moments.covariance, prior, prior_weight);
}

Eigen::Matrix3d match_extents(const Points& source, const Points& target, const Eigen::Matrix3d& axes,
                              const Eigen::Matrix3d& rotation) {
  auto extents = [&](const Points& points, const Eigen::Matrix3d& frame) {
    Eigen::AlignedBox3d box;
    for (const Vec3& point : points) box.extend(Vec3(frame.transpose() * point));
    return Vec3(box.sizes());
  };
  const Vec3 ratio = extents(target, axes).cwiseQuotient(extents(source, rotation.transpose() * axes));
  return axes * ratio.asDiagonal() * axes.transpose() * rotation;
}

}  // namespace partwise
