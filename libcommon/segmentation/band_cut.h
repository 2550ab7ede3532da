#pragma once

#include "segmentation/random_walker.h"
#include "segmentation/seeds.h"

namespace partwise {

struct BandCutOptions {
  double band = 0.3;  ///< facets whose second probability exceeds this share of the first may change
  double probability_weight = 0.3;  ///< of a facet's loss of probability, against the cost of boundary
  int most_rounds = 8;              ///< over all parts; usually two or three suffice
};

/// Straightens the boundaries that a random walk left: labels that minimise, over the facets whose part is in
/// doubt,
///
///   sum over edges between two parts of boundary_costs
///   + probability_weight * sum over facets of (sqrt(A) / h) (p1 / p_k - p1 / p0)
///
/// with p0 >= p1 >= ... a facet's probabilities, p_k that of its label, A its area, h the mean edge length.
/// Seeded facets and those with p1 <= band p0 keep their most probable part, the others take one of their
/// best four. By alpha expansion (Boykov, Veksler and Zabih 2001), parts in order, until a round changes
/// nothing. \pre boundary_costs has one entry per edge, see crease_field.h
std::vector<int> cut_band(const TriMesh& mesh, const Seeds& seeds, const PartProbabilities& probabilities,
                          const std::vector<double>& boundary_costs, const BandCutOptions& options);

/// The same on any graph, from `labels` on: free nodes may take one of their best four parts, or keep theirs.
std::vector<int> cut_band(const FacetGraph& graph, const std::vector<bool>& is_free, std::vector<int> labels,
                          const PartProbabilities& probabilities, const BandCutOptions& options);

/// The nodes whose part is in doubt: not fixed, second probability above `band` times the first.
std::vector<bool> nodes_in_doubt(const std::vector<bool>& is_fixed, const PartProbabilities& probabilities,
                                 double band);

}  // namespace partwise
