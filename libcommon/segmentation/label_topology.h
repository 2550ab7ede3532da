#pragma once

#include <vector>

#include "mesh/segmentation.h"

namespace partwise {

/// Facets around `vertex` in cyclic order; -1 stands for the outside at a vertex of the mesh's boundary.
std::vector<int> facets_around(const TriMesh& mesh, int vertex);

/// Fans of equal labels around a vertex beyond one per label (the outside counts as a label): 0 at a vertex
/// where no part is pinched.
int extra_fans(const TriMesh& mesh, const std::vector<int>& labels, int vertex);

/// Connected sets of facets of one label.
struct LabelComponents {
  std::vector<int> of_facet;             ///< per facet: its component
  std::vector<std::vector<int>> facets;  ///< per component; numbered by their first facet
};

LabelComponents label_components(const TriMesh& mesh, const std::vector<int>& labels);

}  // namespace partwise
