#pragma once

#include <optional>

#include "mapping/hull_to_hull.h"
#include "mapping/model_pair.h"
#include "mapping/pin_on_hull.h"
#include "mapping/release_markers.h"

namespace partwise {

/// One part of the source on its way to the target's hull; everything relative to the two hulls' centres.
class PartToHull {
 public:
  /// \param part in the target's order
  /// \param alignment of the models; decides how the part is turned where its fixed points leave that open
  PartToHull(const ModelPair& pair, const HullMap& source, const HullMap& target,
             const std::vector<BoundaryPlacement>& placements, int part, const Eigen::Affine3d& alignment);

  struct Result {
    Points images;  ///< per local vertex of the source's part, in the target's space
    PartCrossing crossing;
    std::vector<double> marker_distances;  ///< per marker constraint of this part, in units of the model
    std::vector<bool> marker_held;         ///< per marker constraint: false when it was let go
  };
  Result run(const HullToHullOptions& options) const;

  /// How much the part resists its places, in a few steps: its distortion beyond that of an isometry once it
  /// is drawn there, and what is left to draw. Infinite when its own map Q^s has folds.
  double strain() const;
  double area() const { return hull_.area(); }  ///< of the target's hull

 private:
  /// A marker of this part: its point in local facets of both parts, and where it belongs.
  struct LocalMarker {
    SurfacePoint source;
    Vec3 goal = Vec3::Zero();  ///< in the facet of Q^t, hence within the hull
  };

  /// The vertex that stands for a marker: with which weight it enters the marker's place.
  struct MarkerPin {
    Pin pin;
    std::size_t marker = 0;
    double weight = 1;
  };

  void pin_boundary(const std::vector<BoundaryPlacement>& placements);
  void pin_caps(const std::vector<BoundaryPlacement>& placements);
  void find_markers();
  void align(const Eigen::Affine3d& alignment);
  std::vector<MarkerPin> marker_pins() const;
  void place_exactly(const MarkerPin& pin, Points& images) const;
  Vec3 marker_image(const LocalMarker& marker, const Points& images) const;
  int free_folds(const Points& images) const;
  bool is_in_place(const std::vector<Pin>& markers) const;
  MarkedMap marked(const std::vector<Pin>& markers, const HullToHullOptions& options) const;
  PinnedMap pinned(const std::vector<Pin>& markers, const std::vector<Pin>& drawn,
                   const HullToHullOptions& options) const;
  Points energy_start(const std::vector<Pin>& markers, const EnergyMapOptions& options) const;

  const ModelPair& pair_;
  const Part& source_;
  const Part& target_;
  int part_;
  const ConvexHull& source_hull_;
  const ConvexHull& target_hull_;
  Vec3 source_centre_, target_centre_;
  StarHull hull_;
  Points own_;            ///< Q^s about the source's centre
  Points target_images_;  ///< Q^t about the target's centre
  std::vector<double> weights_;
  std::vector<std::array<int, 2>> kept_;
  std::vector<Pin> pins_;  ///< boundary and caps
  std::vector<LocalMarker> markers_;
  Eigen::Matrix3d linear_ = Eigen::Matrix3d::Identity();
  Points start_;
};

}  // namespace partwise
