#include "deform/facet_transform.h"

#include <Eigen/SVD>

#include <algorithm>

namespace partwise {
namespace {

constexpr double kLeastHeight = 1e-9;  ///< of a facet over its longest edge, below which it is a line

/// Two edges and the unit normal as columns; none for a facet without area.
std::optional<Eigen::Matrix3d> facet_frame(const Points& points, const Facet& facet) {
  const Vec3 e1 = points[facet[1]] - points[facet[0]], e2 = points[facet[2]] - points[facet[0]];
  const Vec3 normal = e1.cross(e2);
  const double longest = std::max({e1.squaredNorm(), e2.squaredNorm(), (e2 - e1).squaredNorm()});
  if (!(normal.norm() > kLeastHeight * longest)) return {};
  Eigen::Matrix3d frame;
  frame << e1, e2, normal.normalized();
  return frame;
}

}  // namespace

std::optional<FacetTransform> facet_transform(const Points& reference, const Points& deformed,
                                              const Facet& facet) {
  const auto from = facet_frame(reference, facet), to = facet_frame(deformed, facet);
  if (!from || !to) return {};
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(*to * from->inverse(),
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  // Normal goes to normal, so the determinant is positive and U V^T a rotation.
  return FacetTransform{svd.matrixU() * svd.matrixV().transpose(),
                        svd.matrixV() * svd.singularValues().asDiagonal() * svd.matrixV().transpose()};
}

std::optional<Eigen::Matrix3d> nearest_rotation(const Eigen::Matrix3d& matrix) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Vec3& sizes = svd.singularValues();
  if (!(sizes[1] > 1e-6 * sizes[0])) return {};
  Vec3 signs = Vec3::Ones();
  if (svd.matrixU().determinant() * svd.matrixV().determinant() < 0) signs[2] = -1;
  return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

}  // namespace partwise
