#include "mapping/map_progressively.h"

#include <Eigen/SVD>

#include <algorithm>
#include <numeric>
#include <utility>

#include "error.h"
#include "geometry/convex_hull.h"
#include "geometry/normals.h"
#include "mapping/lifted_embedding.h"
#include "mapping/progressive_embedding.h"
#include "mapping/relax_on_hull.h"
#include "measure/hull_folds.h"

namespace partwise {
namespace {

constexpr double kCapWeight = 0.1;
constexpr std::size_t kMostRemovals = 8;  // besides caps
constexpr int kStepsFromLifting = 300;

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

/// Where to try to open a part: centres of caps, then all others, largest rings first.
std::vector<int> vertices_to_remove(const Part& part) {
  const std::vector<double> areas = ring_areas(part.mesh.points(), part.mesh.facets());
  std::vector<int> order(part.mesh.vertex_count());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int u, int v) {
    if (part.is_cap_vertex(u) != part.is_cap_vertex(v)) return part.is_cap_vertex(u);
    return areas[u] > areas[v];
  });
  order.resize(std::min<std::size_t>(order.size(), part.cap_vertices.size() + kMostRemovals));
  return order;
}

/// The part's own vertices seen from the hull's centre.
Points projected(const Part& part, const StarHull& hull, const Vec3& centre) {
  Points images;
  for (const Vec3& point : part.mesh.points()) {
    const Vec3 direction = point - centre;
    images.push_back(direction.isZero(0) ? Vec3(Vec3::UnitX()) : direction);
  }
  const std::vector<StarHull::Place> places = hull.project(images);
  for (std::size_t v = 0; v < places.size(); ++v) images[v] = places[v].position;
  return images;
}

/// The embedding turned towards the part's own directions, on the hull, with little distortion. A part that
/// is hardly concave comes out best where it is.
ProgressiveMap relaxed(const Part& part, const ConvexHull& hull, Points directions,
                       const HullRelaxationOptions& options) {
  const Vec3 centre = hull_centre(hull);
  const Eigen::Matrix3d rotation = closest_rotation(part.mesh, centre, directions);
  for (Vec3& direction : directions) direction = rotation * direction;
  const std::vector<double> weights = distortion_weights(part);
  const StarHull star(hull, centre);
  HullRelaxation result = relax_on_hull(part.mesh, weights, star, directions, {}, options);
  for (Vec3& image : result.images) image += centre;
  Points own = projected(part, star, centre);
  const double distortion = hull_distortion(part.mesh, weights, star, own);
  for (Vec3& image : own) image += centre;
  if (distortion <= result.distortion && hull_folds(own, part.mesh.facets(), centre).one_to_one()) {
    return {std::move(own), distortion, 0};
  }
  return {std::move(result.images), result.distortion, result.iterations};
}

}  // namespace

std::vector<double> distortion_weights(const Part& part) {
  std::vector<double> weights(part.mesh.vertex_count(), 1.0);
  for (const int v : part.cap_vertices) weights[v] = kCapWeight;
  return weights;
}

ProgressiveMap map_progressively(const Part& part, const ConvexHull& hull) {
  return relaxed(part, hull, embed_progressively(part.mesh, distortion_weights(part)), {});
}

ProgressiveMap map_by_lifting(const Part& part, const ConvexHull& hull) {
  HullRelaxationOptions options;
  options.most_iterations = kStepsFromLifting;
  options.least_decrease = 1e-4;
  for (const int vertex : vertices_to_remove(part)) {
    try {
      return relaxed(part, hull, embed_by_lifting(part.mesh, vertex), options);
    } catch (const ComputationError&) {
      continue;  // below double precision from there; another vertex crowds others together
    }
  }
  throw ComputationError("no disc of it can be lifted to the sphere in double precision");
}

}  // namespace partwise
