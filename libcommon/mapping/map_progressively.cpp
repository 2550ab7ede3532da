#include "mapping/map_progressively.h"

#include <Eigen/SVD>

#include "geometry/convex_hull.h"
#include "geometry/normals.h"
#include "mapping/progressive_embedding.h"
#include "mapping/relax_on_hull.h"

namespace partwise {
namespace {

constexpr double kCapWeight = 0.1;

/// The rotation that brings `directions` closest to those of the points around `centre`, weighted by ring
/// areas.
Eigen::Matrix3d closest_rotation(const TriMesh& mesh, const Vec3& centre, const Points& directions) {
  const std::vector<double> weights = ring_areas(mesh.points(), mesh.facets());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    covariance += weights[v] * (mesh.point(v) - centre).stableNormalized() * directions[v].transpose();
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Vec3 signs = Vec3::Ones();
  signs.z() = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

}  // namespace

std::vector<double> distortion_weights(const Part& part) {
  std::vector<double> weights(part.mesh.vertex_count(), 1.0);
  for (const int v : part.cap_vertices) weights[v] = kCapWeight;
  return weights;
}

ProgressiveMap map_progressively(const Part& part, const ConvexHull& hull) {
  const std::vector<double> weights = distortion_weights(part);
  const Vec3 centre = hull_centre(hull);
  Points directions = embed_progressively(part.mesh, weights);
  const Eigen::Matrix3d rotation = closest_rotation(part.mesh, centre, directions);
  for (Vec3& direction : directions) direction = rotation * direction;
  HullRelaxation relaxed = relax_on_hull(part.mesh, weights, StarHull(hull, centre), directions, {}, {});
  for (Vec3& image : relaxed.images) image += centre;
  return {std::move(relaxed.images), relaxed.distortion, relaxed.iterations};
}

}  // namespace partwise
