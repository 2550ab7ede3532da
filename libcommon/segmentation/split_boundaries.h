#pragma once

#include <string>
#include <vector>

#include "segmentation/seeds.h"

namespace partwise {

/// A mesh whose facets were cut along smooth part boundaries.
struct SplitMeshLabels {
  TriMesh mesh;  ///< the first vertices are the original's, in its order; the others lie on its facets
  std::vector<int> labels;  ///< per facet of `mesh`
  int added_vertices = 0;
  int added_facets = 0;
};

/// Lets part boundaries cross facets, because on coarse meshes the edges alone limit how smooth they can be.
///
/// Each part's share of the facets around a vertex is averaged over the neighbours `rounds` times; where the
/// largest share changes hands along an edge the edge is split, between a fifth and four fifths of its length
/// (slivers would do harm later). A facet where three parts meet gets a vertex inside, the cross point.
/// Seeded vertices keep their part; every boundary is a simple curve by construction. \pre labels are valid,
/// see label_repair.h \throws ComputationError naming the part that is too thin to keep a vertex, or its
/// place, in this way
SplitMeshLabels split_along_boundaries(const TriMesh& mesh, const std::vector<std::string>& names,
                                       const Seeds& seeds, const std::vector<int>& labels, int rounds);

}  // namespace partwise
