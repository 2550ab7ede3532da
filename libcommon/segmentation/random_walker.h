#pragma once

#include <Eigen/Core>

#include <vector>

#include "segmentation/seeds.h"

namespace partwise {

/// Row f: per part, the probability that a walk from facet f first meets a seed of that part.
using PartProbabilities = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Random walks over facets, reluctant to cross concave edges; seeds have probability 1 for their own part.
///
/// The walk crosses edge e with weight |e| / d exp(-3 min(c / 20, 4)): d the way from centroid over the
/// edge's midpoint to centroid, c the edge's concavity. Differs from [Wu11]: growth (see growth.h) leaves
/// ragged boundaries that leak through the shoulder; walks average over all ways and stop at creases. \param
/// concavity per edge, see edge_concavity \pre every component of the mesh has a seeded facet \throws
/// ComputationError when the linear system cannot be factorised
PartProbabilities walk_randomly(const TriMesh& mesh, const Seeds& seeds, int part_count,
                                const std::vector<double>& concavity);

/// Per facet the most probable part; of equal ones (within 1e-12) the first.
std::vector<int> most_probable_parts(const PartProbabilities& probabilities);

}  // namespace partwise
