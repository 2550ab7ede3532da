#pragma once

#include <optional>

#include "mesh/types.h"

namespace partwise {

/// How a facet is turned and stretched from one shape into another: F = rotation * stretch, the polar split.
struct FacetTransform {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d stretch = Eigen::Matrix3d::Identity();  ///< symmetric, positive; 1 along the normal

  Eigen::Matrix3d gradient() const { return rotation * stretch; }
};

/// The deformation gradient that takes the edges of `facet` in `reference` to those in `deformed`, and unit
/// normal to unit normal (as Sumner & Popovic 2004, whose normal has another length).
/// \return none when the facet has no area, or next to none, in either shape
std::optional<FacetTransform> facet_transform(const Points& reference, const Points& deformed,
                                              const Facet& facet);

/// The rotation nearest to `matrix`; none when two directions of it are lost.
std::optional<Eigen::Matrix3d> nearest_rotation(const Eigen::Matrix3d& matrix);

}  // namespace partwise
