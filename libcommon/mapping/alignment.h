#pragma once

#include "mesh/types.h"

namespace partwise {

/// Points known on two shapes, with the weight of each pair.
struct MatchedPoints {
  Points source;
  Points target;
  std::vector<double> weights;

  void add(const Vec3& source_point, const Vec3& target_point, double weight = 1);
};

/// The similarity (rotation, uniform scale, translation) that brings `matched.source` closest to
/// `matched.target` (Umeyama 1991). Never a reflection.
///
/// What the points leave open comes from `prior`: the rotation about a line when they are collinear, rotation
/// and scale when they coincide, everything when there are none. Exact for a similar copy whose points are
/// not collinear. Equivariant: scaling either side scales the result.
Eigen::Affine3d fit_similarity(const MatchedPoints& matched, const Eigen::Affine3d& prior);

/// The linear map about two centres that brings `source_centre + x` closest to `target_centre + A x`, drawn
/// towards `prior` where there are few points.
///
/// Minimises the weighted mean of |A x - y|^2 over the pairs plus `stiffness` * |(A - prior) x|^2 in the mean
/// over directions; x and y are the points relative to their centres. Exact when `prior` is.
/// \pre stiffness > 0
Eigen::Matrix3d fit_linear(const MatchedPoints& matched, const Vec3& source_centre, const Vec3& target_centre,
                           const Eigen::Matrix3d& prior, double stiffness);

/// The rotation that brings the source's points, seen from its centre, closest to the target's, drawn towards
/// `prior` by `prior_weight` times the weight of the points; about axes that the points leave open it is the
/// prior's in any case. \pre prior_weight >= 0
Eigen::Matrix3d fit_rotation(const MatchedPoints& matched, const Vec3& source_centre,
                             const Vec3& target_centre, const Eigen::Matrix3d& prior, double prior_weight);

/// `rotation` followed by a scaling along `axes` (orthonormal columns) that gives the rotated source the
/// extents of the target there. Both sets of points are given relative to their centres and span space.
Eigen::Matrix3d match_extents(const Points& source, const Points& target, const Eigen::Matrix3d& axes,
                              const Eigen::Matrix3d& rotation);

}  // namespace partwise
