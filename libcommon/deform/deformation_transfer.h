#pragma once

#include <optional>
#include <vector>

#include "deform/facet_correspondence.h"
#include "deform/held_points.h"
#include "deform/surface_integration.h"

namespace partwise {

/// One place on both models that moves alike.
struct HeldPair {
  SurfacePoint leader, follower;
};

struct DeformationTransferOptions {
  /// Turn deformations by the rotation that takes the one model nearest to the other; without, "up" is up on
  /// both, as in the literature.
  bool turn = false;

  /// Places of the follower that go exactly as far from where they are at rest as their partners do on the
  /// leader, scaled by the models' diagonals: a foot that stands on the one stands on the other. See
  /// HeldPoints.
  std::vector<HeldPair> held{};
};

/// Gives one model (the follower) the poses of another (the leader).
///
/// Every facet of the follower is to deform as its corresponding facets of the leader do: the mean of their
/// deformation gradients by share; the positions are those whose edges come nearest. After Sumner and Popovic
/// 2004, whose least squares over pairs of facets this is, with gradients integrated as by Botsch et al.
/// 2006. One factorisation, at construction, serves all poses. Where nothing is held, each component moves by
/// as much as the leader does there, scaled by the models' diagonals.
class DeformationTransfer {
 public:
  /// \param leader,follower at rest \pre one list of `correspondence` per facet of the follower
  /// \throws InputError when two of the places to hold are the same
  DeformationTransfer(const TriMesh& leader, const TriMesh& follower, FacetCorrespondence correspondence,
                      const DeformationTransferOptions& options = {});

  /// The follower's positions for each pose of the leader.
  /// \throws InputError when a pose has another number of vertices than the leader
  std::vector<Points> follow(const std::vector<Points>& poses) const;

  /// Angle in degrees by which the models are turned against each other.
  double turned_by() const { return angle_; }

 private:
  std::vector<Eigen::Matrix3d> gradients(const Points& pose) const;
  Points component_moves(const Points& pose) const;
  void place(Points& followed, const Points& pose) const;

  TriMesh leader_, follower_;
  FacetCorrespondence correspondence_;
  Eigen::Matrix3d turn_ = Eigen::Matrix3d::Identity();
  double angle_ = 0;
  double scale_ = 1;
  std::vector<double> areas_;  // of the follower's facets
  SurfaceIntegration integration_;
  std::vector<HeldPair> held_;
  std::optional<HeldPoints> holds_;  // of the follower
};

}  // namespace partwise
