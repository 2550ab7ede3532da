#include "deform/deformation_transfer.h"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "deform/facet_transform.h"
#include "deform/rotation_logarithms.h"
#include "error.h"
#include "geometry/normals.h"
#include "mapping/parallel_parts.h"

namespace partwise {
namespace {

Vec3 centroid(const Points& points, const Facet& facet) {
  return (points[facet[0]] + points[facet[1]] + points[facet[2]]) / 3;
}

/// Mean over the corresponding facets of the leader.
template <class Value, class Function>
Value mean_of(const std::vector<FacetShare>& shares, Value sum, Function value) {
  for (const FacetShare& share : shares) sum += share.share * value(share.facet);
  return sum;
}

/// The rotation that takes the leader's facets nearest to where the follower's are, about their means.
Eigen::Matrix3d relative_turn(const TriMesh& leader, const TriMesh& follower,
                              const FacetCorrespondence& correspondence, const std::vector<double>& areas) {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  double total = 0;
  for (std::size_t f = 0; f < areas.size(); ++f) {
    const Vec3 a = mean_of(correspondence[f], Vec3(Vec3::Zero()),
                           [&](int facet) { return centroid(leader.points(), leader.facet(facet)); });
    const Vec3 b = centroid(follower.points(), follower.facet(static_cast<int>(f)));
    from += areas[f] * a;
    to += areas[f] * b;
    products += areas[f] * b * a.transpose();
    total += areas[f];
  }
  return nearest_rotation(products - to * from.transpose() / total).value_or(Eigen::Matrix3d::Identity());
}

/// The deformation gradient with the normal stretched as the facet is in the mean, after Sumner and Popovic:
/// corresponding facets need not be parallel, so what happens along the normal matters.
Eigen::Matrix3d thickened(const TriMesh& mesh, int facet, const FacetTransform& transform) {
  const auto& [a, b, c] = mesh.facet(facet);
  const Vec3 normal = area_vector(mesh.point(a), mesh.point(b), mesh.point(c)).normalized();
  const double stretch = std::sqrt(transform.stretch.determinant());
  return transform.rotation * (transform.stretch + (stretch - 1) * normal * normal.transpose());
}

/// Facets without area take the mean of their neighbours, from ring to ring.
void fill_unknown(const TriMesh& mesh, std::vector<Eigen::Matrix3d>& gradients, std::vector<bool> known) {
  for (bool progress = true; progress;) {
    progress = false;
    const std::vector<bool> before = known;
    for (int f = 0; f < mesh.facet_count(); ++f) {
      if (before[f]) continue;
      Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
      int count = 0;
      for (const auto neighbour : mesh.half_edges().ff_range(OpenMesh::FaceHandle(f))) {
        if (!before[neighbour.idx()]) continue;
        sum += gradients[neighbour.idx()];
        ++count;
      }
      if (count == 0) continue;
      gradients[f] = sum / count;
      known[f] = progress = true;
    }
  }
}

}  // namespace

DeformationTransfer::DeformationTransfer(const TriMesh& leader, const TriMesh& follower,
                                         FacetCorrespondence correspondence,
                                         const DeformationTransferOptions& options)
    : leader_(leader),
      follower_(follower),
      correspondence_(std::move(correspondence)),
      areas_(facet_areas(follower.points(), follower.facets())),
      integration_(follower, {follower.points()}),
      held_(options.held) {
  if (leader.diagonal() > 0) scale_ = follower.diagonal() / leader.diagonal();
  const Eigen::Matrix3d turn = relative_turn(leader, follower, correspondence_, areas_);
  angle_ = rotation_logarithm(turn).norm() * 180 / std::numbers::pi;
  if (options.turn) turn_ = turn;
  if (held_.empty()) return;
  std::vector<SurfacePoint> points;
  for (const HeldPair& pair : held_) points.push_back(pair.follower);
  holds_.emplace(follower_, integration_, std::move(points));
}

std::vector<Eigen::Matrix3d> DeformationTransfer::gradients(const Points& pose) const {
  std::vector<Eigen::Matrix3d> result(leader_.facet_count(), Eigen::Matrix3d::Identity());
  std::vector<bool> known(result.size(), false);
  for (int f = 0; f < leader_.facet_count(); ++f) {
    const auto transform = facet_transform(leader_.points(), pose, leader_.facet(f));
    known[f] = transform.has_value();
    if (transform) result[f] = turn_ * thickened(leader_, f, *transform) * turn_.transpose();
  }
  fill_unknown(leader_, result, std::move(known));
  return result;
}

Points DeformationTransfer::component_moves(const Points& pose) const {
  Points moves(integration_.component_count(), Vec3::Zero());
  std::vector<double> totals(moves.size(), 0);
  for (std::size_t f = 0; f < areas_.size(); ++f) {
    const int component = integration_.components()[follower_.facet(static_cast<int>(f))[0]];
    const Vec3 move = mean_of(correspondence_[f], Vec3(Vec3::Zero()), [&](int facet) {
      const Facet& corners = leader_.facet(facet);
      return Vec3(centroid(pose, corners) - centroid(leader_.points(), corners));
    });
    moves[component] += areas_[f] * scale_ * (turn_ * move);
    totals[component] += areas_[f];
  }
  for (std::size_t k = 0; k < moves.size(); ++k) {
    if (totals[k] > 0) moves[k] /= totals[k];
  }
  return moves;
}

/// Where the follower stands, which edges do not say.
void DeformationTransfer::place(Points& followed, const Points& pose) const {
  // The mean over area, unlike that over vertices, does not depend on how finely the models are cut.
  Points moves = component_moves(pose);
  std::vector<double> totals(moves.size(), 0);
  Points drift(moves.size(), Vec3::Zero());
  for (std::size_t f = 0; f < areas_.size(); ++f) {
    const Facet& corners = follower_.facet(static_cast<int>(f));
    const int component = integration_.components()[corners[0]];
    drift[component] += areas_[f] * (centroid(follower_.points(), corners) - centroid(followed, corners));
    totals[component] += areas_[f];
  }
  for (std::size_t k = 0; k < moves.size(); ++k) {
    if (totals[k] > 0) moves[k] += drift[k] / totals[k];
  }
  for (std::size_t v = 0; v < followed.size(); ++v) followed[v] += moves[integration_.components()[v]];
  if (!holds_) return;
  const TriMesh posed = leader_.with_points(pose);
  Points places;
  for (const HeldPair& pair : held_) {
    const Vec3 move = position(posed, pair.leader) - position(leader_, pair.leader);
    places.push_back(position(follower_, pair.follower) + scale_ * (turn_ * move));
  }
  followed = holds_->corrected(std::move(followed), places);
}

std::vector<Points> DeformationTransfer::follow(const std::vector<Points>& poses) const {
  const int count = static_cast<int>(poses.size());
  for (int i = 0; i < count; ++i) {
    if (poses[i].size() == leader_.points().size()) continue;
    throw InputError("pose " + std::to_string(i) + " has " + std::to_string(poses[i].size()) +
                     " vertices instead of " + std::to_string(leader_.vertex_count()));
  }
  std::vector<std::vector<Eigen::Matrix3d>> of_leader(count);
  for_each_part(count, [&](int i) { of_leader[i] = gradients(poses[i]); });
  const auto edges = [&](int pose, int facet) {
    const Eigen::Matrix3d gradient =
        mean_of(correspondence_[facet], Eigen::Matrix3d(Eigen::Matrix3d::Zero()),
                [&](int leading) -> const Eigen::Matrix3d& { return of_leader[pose][leading]; });
    FacetEdges wanted = facet_edges(follower_.points(), follower_.facet(facet));
    for (Vec3& edge : wanted) edge = gradient * edge;
    return wanted;
  };
  std::vector<Points> followed = integration_.integrate(
      edges, std::vector<Points>(count, Points(integration_.component_count(), Vec3::Zero())));
  for_each_part(count, [&](int i) { place(followed[i], poses[i]); });
  return followed;
}

}  // namespace partwise
