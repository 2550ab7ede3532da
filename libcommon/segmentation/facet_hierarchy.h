#pragma once

#include <vector>

#include "segmentation/facet_graph.h"

namespace partwise {

/// Facets joined in pairs, the pairs in pairs again, and so on: level 0 are the facets of a mesh, a node of a
/// level is a connected group of them. Knows the mesh alone, no strokes and no creases.
class FacetHierarchy {
 public:
  /// Joins until a level has at most `coarsest` nodes (or as few as there are components).
  ///
  /// On each level the two neighbours that share the longest boundary for their areas, L^2 / (A_1 A_2), are
  /// joined first, so that groups stay round and the result does not depend on the numbering (ties aside).
  FacetHierarchy(const TriMesh& mesh, int coarsest);

  /// A level's nodes and links; link_above is the link of the next level that a link becomes, -1 inside a
  /// node.
  struct Level {
    std::vector<int> first, neighbour;  ///< as in FacetGraph
    std::vector<int> parent;            ///< per node its node in the next level; empty in the last level
    std::vector<int> link_above;

    int node_count() const { return static_cast<int>(first.size()) - 1; }
  };
  const std::vector<Level>& levels() const { return levels_; }

  /// Per facet the node of `level` that contains it.
  std::vector<int> nodes_of_facets(int level) const;

 private:
  std::vector<Level> levels_;
};

/// The graphs of all levels: costs and conductances are those of the facets, summed over the links that a
/// link joins.
std::vector<FacetGraph> graphs_of_levels(const FacetHierarchy& hierarchy, FacetGraph facets);

}  // namespace partwise
