#include "mapping/hull_alignment.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <initializer_list>
#include <limits>

namespace partwise {
namespace {

constexpr double kStiffness = 0.3;     ///< of the linear map towards a rotation with scaled axes
constexpr double kLeastStretch = 0.2;  ///< a linear map that flattens more than this is not used
constexpr int kTurns = 8;

class HullAlignment {
 public:
  HullAlignment(const MatchedPoints& matched, const StarHull& hull) : matched_(matched), hull_(hull) {}

  void consider(const Eigen::Matrix3d& linear) {
    const double cost = misfit(linear);
    if (cost >= least_) return;
    least_ = cost;
    best_ = linear;
  }

  /// The turn of the best map's images that brings them closer to the goals.
  Eigen::Matrix3d turned() const {
    MatchedPoints images = matched_;
    for (Vec3& point : images.source) point = hull_.project(best_ * point, 0).position;
    return fit_rotation(images, Vec3::Zero(), Vec3::Zero(), Eigen::Matrix3d::Identity(), 0) * best_;
  }

  double least() const { return least_; }
  const Eigen::Matrix3d& best() const { return best_; }

 private:
  double misfit(const Eigen::Matrix3d& linear) const {
    double sum = 0;
    for (std::size_t i = 0; i < matched_.source.size(); ++i) {
      const Vec3 image = hull_.project(linear * matched_.source[i], 0).position;
      sum += matched_.weights[i] * (image - matched_.target[i]).squaredNorm();
    }
    return sum;
  }

  const MatchedPoints& matched_;
  const StarHull& hull_;
  Eigen::Matrix3d best_ = Eigen::Matrix3d::Identity();
  double least_ = std::numeric_limits<double>::infinity();
};

bool is_usable(const Eigen::Matrix3d& change) {
  const Vec3 stretch = Eigen::JacobiSVD<Eigen::Matrix3d>(change).singularValues();
  return change.determinant() > 0 && stretch[2] > kLeastStretch * stretch[0];
}

}  // namespace

Eigen::Matrix3d align_to_hull(const MatchedPoints& matched, const Points& source_hull,
                              const Points& target_hull, const StarHull& hull,
                              const Eigen::Matrix3d& upright) {
  const Vec3 centre = Vec3::Zero();
  const Eigen::Matrix3d axes =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(hull.second_moments()).eigenvectors();
  HullAlignment alignment(matched, hull);
  for (const double prior_weight : {1e3, 1.0, 0.3, 0.1, 0.0}) {
    const Eigen::Matrix3d rotation = fit_rotation(matched, centre, centre, upright, prior_weight);
    const Eigen::Matrix3d scaled = match_extents(source_hull, target_hull, axes, rotation);
    alignment.consider(scaled);
    const Eigen::Matrix3d linear = fit_linear(matched, centre, centre, scaled, kStiffness);
    if (is_usable(linear * scaled.inverse())) alignment.consider(linear);
  }
  for (int turn = 0; turn < kTurns; ++turn) {
    const double before = alignment.least();
    alignment.consider(alignment.turned());
    if (!(alignment.least() < before * (1 - 1e-3))) break;
  }
  return alignment.best();
}

}  // namespace partwise
