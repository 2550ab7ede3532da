#pragma once

#include <vector>

#include "mesh/tri_mesh.h"

namespace partwise {

/// Facets, or connected groups of facets, and what lies between neighbours: all that the random walker and
/// the band cut know of a mesh. One array per property; links of node i are first[i] to first[i + 1].
struct FacetGraph {
  std::vector<int> first{0};        ///< per node its first link, and the end
  std::vector<int> neighbour;       ///< per link; every link stands at both of its nodes
  std::vector<double> conductance;  ///< per link: how readily a random walk takes it
  std::vector<double> cut_cost;     ///< per link: of a boundary between its nodes
  std::vector<double> size;         ///< per node: sum of sqrt(A) / h over its facets

  int node_count() const { return static_cast<int>(first.size()) - 1; }
};

/// The graph whose nodes are the facets of a mesh, linked over edges.
///
/// Conductance |e| / d exp(-3 min(c / 20, 4)), d the way from centroid over the edge's midpoint to centroid,
/// c the edge's concavity. \param concavity, boundary_costs per edge, see crease_field.h
FacetGraph facet_graph(const TriMesh& mesh, const std::vector<double>& concavity,
                       const std::vector<double>& boundary_costs);

/// Per facet the facets across its edges, in the order of facet_graph's links, and the edges (OpenMesh
/// indices) between.
struct FacetLinks {
  std::vector<int> first{0};
  std::vector<int> neighbour;
  std::vector<int> edge;
};
FacetLinks facet_links(const TriMesh& mesh);

}  // namespace partwise
