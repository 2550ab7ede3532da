#pragma once

#include <optional>
#include <vector>

#include "mesh/part.h"
#include "mesh/split_edges.h"
#include "mesh/surface_point.h"

namespace partwise {

/// A sphere of directions on which a piece of the target is laid out one-to-one, and with it, through the
/// images of its vertices, the same piece of the source.
///
/// A piece is the union of some parts, each of its boundary loops closed by a cap (see extract_piece). A
/// point of a facet has the direction sum b_i d_i of its barycentric coordinates and the facet's directions,
/// which are not normalised: so two charts agree on the edges that they share.
struct Chart {
  std::vector<int> parts;  ///< ascending
  Points directions;       ///< per local vertex of the target's piece; any length > 0
};

/// A vertex that the source's side of charts has on an edge of the source, and the point of the target that
/// it goes to: where a boundary of the target bends between two source vertices, or to give a facet with all
/// corners on a boundary a vertex that can move. The compatible mesh does not have it.
struct AddedVertex {
  EdgePoint place;
  SurfacePoint image;
};

/// The target's side of a chart.
class ChartTarget {
 public:
  /// \param labels per facet of `target`: its part
  /// \throws InputError when the chart has not as many directions as the piece vertices
  ChartTarget(const TriMesh& target, const std::vector<int>& labels, const Chart& chart);

  const Part& piece() const { return piece_; }
  const Points& directions() const { return directions_; }
  bool is_inside(int facet) const { return inside_[facet]; }

  /// Direction of a point of the target; none when it lies outside the piece. A point on the piece's boundary
  /// may be given in a facet across.
  std::optional<Vec3> direction(const SurfacePoint& point) const;

  /// A place on one of the piece's boundary loops.
  struct LoopPlace {
    int loop = 0;
    double position = 0;  ///< index of a vertex of the loop plus fraction of the edge to the next, or -1
  };
  /// \return none when `point` is no vertex of a loop and on no edge of one
  std::optional<LoopPlace> on_loop(const SurfacePoint& point) const;

 private:
  Part piece_;
  Points directions_;
  std::vector<bool> inside_;
  const TriMesh* target_;
  std::vector<LoopPlace> loop_places_;  // per local vertex; position -1 inside
};

/// Which facets belong to a chart. \param labels per facet: its part
std::vector<bool> facets_of(const Chart& chart, const std::vector<int>& labels);

}  // namespace partwise
