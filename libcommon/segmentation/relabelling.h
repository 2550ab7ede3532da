#pragma once

#include <optional>
#include <vector>

#include "segmentation/seeds.h"

namespace partwise {

/// A labelling under local changes, each judged before it is made.
class Relabelling {
 public:
  /// Facets that all take one label, and what that costs: change in boundary cost, plus area and seeds given
  /// away.
  struct Move {
    std::vector<int> facets;
    int label = 0;
    double cost = 0;
  };

  /// \param boundary_costs per edge, see crease_field.h; both references must outlive this object
  Relabelling(const TriMesh& mesh, const Seeds& seeds, std::vector<int> labels,
              const std::vector<double>& boundary_costs);

  const std::vector<int>& labels() const { return labels_; }
  void relabel(const std::vector<int>& facets, int label);

  double area(const std::vector<int>& facets) const;
  double seeded_area(const std::vector<int>& facets, int part) const;
  double boundary_cost(OpenMesh::HalfedgeHandle h) const;

  /// The move that gives `facets`, and small pieces thereby cut off their part, to `label`.
  ///
  /// None when it would not lower the number of extra fans, would use up a part or cut one in two. Leaves the
  /// labelling as it is.
  /// \pre facets and the part `label` together are connected
  std::optional<Move> evaluate(const std::vector<int>& facets, int label) const;

 private:
  class Trial;

  const TriMesh& mesh_;
  const Seeds& seeds_;
  const std::vector<double>& boundary_costs_;
  std::vector<double> areas_;
  double edge_length_ = 0;
  mutable std::vector<int> labels_;  // changed and restored by evaluate()
};

}  // namespace partwise
