#pragma once

#include <Eigen/Core>

#include <vector>

#include "segmentation/facet_graph.h"
#include "segmentation/seeds.h"

namespace partwise {

/// Row f: per part, the probability that a walk from facet f first meets a seed of that part.
using PartProbabilities = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Random walks over facets, reluctant to cross concave edges; seeds have probability 1 for their own part.
///
/// The walk crosses an edge with its conductance, see facet_graph(). Differs from [Wu11]: growth (see
/// growth.h) leaves ragged boundaries that leak through the shoulder; walks average over all ways and stop at
/// creases. \param concavity per edge, see edge_concavity \pre every component of the mesh has a seeded facet
/// \throws ComputationError when the linear system cannot be factorised
PartProbabilities walk_randomly(const TriMesh& mesh, const Seeds& seeds, int part_count,
                                const std::vector<double>& concavity);

/// The same on any graph: rows of `values` that are fixed stay, the others become the average of their
/// neighbours', weighted by conductance. Exact, by one sparse factorisation.
/// \pre every component of the graph has a fixed node \throws ComputationError as above
PartProbabilities walk_randomly(const FacetGraph& graph, const std::vector<bool>& is_fixed,
                                PartProbabilities values);

/// A few steps towards walk_randomly's result: each replaces all free rows by the average of their
/// neighbours' at once, so that the numbering of the nodes does not matter.
PartProbabilities average_neighbours(const FacetGraph& graph, const std::vector<bool>& is_fixed,
                                     PartProbabilities values, int steps);

/// Per facet the most probable part; of equal ones (within 1e-12) the first.
std::vector<int> most_probable_parts(const PartProbabilities& probabilities);

}  // namespace partwise
