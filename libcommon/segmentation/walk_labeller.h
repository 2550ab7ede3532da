#pragma once

#include <optional>

#include "segmentation/band_cut.h"
#include "segmentation/facet_hierarchy.h"

namespace partwise {

/// Labels the facets of one mesh by random walks and band cuts, for one set of strokes after another.
///
/// Keeps what strokes do not change: the costs of boundaries by edge, the graph of facets and, above
/// `largest_exact` facets, its coarser levels. About 300 bytes per facet.
class WalkLabeller {
 public:
  /// \param largest_exact facets of the largest mesh that is labelled on one level, by a linear system over
  ///        all facets; larger ones see multilevel_labels.h
  WalkLabeller(const TriMesh& mesh, int largest_exact);

  /// Per edge, see crease_field.h.
  const std::vector<double>& boundary_costs() const { return boundary_costs_; }

  /// A part per facet; parts may still be pinched or in several pieces.
  /// \pre every component of the mesh has a seeded facet
  std::vector<int> labels(const Seeds& seeds, int part_count, const BandCutOptions& options) const;

 private:
  std::vector<double> boundary_costs_;
  std::optional<FacetHierarchy> hierarchy_;
  std::vector<FacetGraph> graphs_;  // by level, the facets first
};

}  // namespace partwise
