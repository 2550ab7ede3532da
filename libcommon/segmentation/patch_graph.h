#pragma once

#include <vector>

#include "mesh/tri_mesh.h"

namespace partwise {

/// A mesh in few patches, connected groups of facets: enough to look for where to cut it.
struct PatchGraph {
  std::vector<int> first, neighbour;  ///< links of patch i are first[i] to first[i + 1]
  std::vector<double> border;         ///< per link: length of the common boundary, in units of the model
  std::vector<double> rim;            ///< per patch: length of the mesh's own boundary that it has
  std::vector<double> area;           ///< per patch, in squared units
  Points centre;                      ///< per patch: its centroid
  std::vector<int> vertex;            ///< per patch: the vertex of its facets nearest to the centroid

  int count() const { return static_cast<int>(centre.size()); }
};

/// \param most how many patches there may be (apart from one per component)
PatchGraph patch_graph(const TriMesh& mesh, int most);

/// Ways from centre to centre.
struct PatchWays {
  std::vector<int> order;        ///< patches in reach, by distance
  std::vector<double> distance;  ///< per patch; infinite out of reach
  std::vector<int> previous;     ///< per patch: the one before it on its way, or -1
};

/// Shortest ways from `starts` through patches for which `may_pass` holds.
PatchWays patch_ways(const PatchGraph& graph, const std::vector<int>& starts,
                     const std::vector<bool>& may_pass);

/// Patches for which `inside` holds, in connected groups, that of the largest area first.
std::vector<std::vector<int>> connected_groups(const PatchGraph& graph, const std::vector<bool>& inside);

}  // namespace partwise
