#pragma once

#include <vector>

#include "remeshing/chart_source.h"

namespace partwise {

/// Keeps a one-to-one map one-to-one while source vertices move over the target: says of every move whether
/// all facets around the vertex stay positively oriented in its chart, by the exact predicate.
class MapGuard {
 public:
  /// Without charts in `mesh` every move is allowed.
  explicit MapGuard(const CompatibleMesh& mesh);

  bool has_charts() const { return !charts_.empty(); }

  /// Whether a vertex lies on the boundary of a chart, where it has to stay.
  bool is_held(int source_vertex) const { return has_charts() && homes_[source_vertex].chart < 0; }

  bool allows(int source_vertex, const SurfacePoint& image) const;

  /// Notes a move. \pre allows(source_vertex, image)
  void place(int source_vertex, const SurfacePoint& image);

 private:
  struct Home {
    int chart = -1;
    int local = -1;
  };
  struct Sides {
    ChartTarget target;
    ChartSource source;
  };

  std::vector<Sides> charts_;
  std::vector<Home> homes_;  // per source vertex
};

}  // namespace partwise
