#pragma once

#include <iosfwd>
#include <vector>

#include "mesh/surface_point.h"

namespace partwise {

/// Per source vertex: the target vertex it truly corresponds to, or kNoTruth.
using GroundTruth = std::vector<int>;
inline constexpr int kNoTruth = -1;

/// Geodesic distances between images and true images over the square root of the target's area.
struct GroundTruthErrors {
  int vertices = 0;     ///< compared
  int unreachable = 0;  ///< of them with an image in another component; their error counts as infinite
  double mean = 0;
  double median = 0;
  double quantile_90 = 0;
  double quantile_99 = 0;
  double max = 0;
  double share_below_05 = 0;  ///< share of the vertices with an error below 0.05
  double share_below_10 = 0;  ///< below 0.1
  double share_below_25 = 0;  ///< below 0.25
};

/// Vertex i corresponds to vertex i. \throws InputError when the target has fewer vertices than the source.
GroundTruth identity_truth(const TriMesh& source, const TriMesh& target);

/// One target vertex per line, as many lines as the source has vertices; -1 where none is known.
/// \throws InputError naming the first line that does not fit the meshes
GroundTruth read_truth(std::istream& in, const TriMesh& source, const TriMesh& target);

/// Quantiles are those of the sorted errors at rank ceil(q n). Distances are those of GeodesicSearch.
/// \pre truth fits both meshes \throws InputError when no vertex has a truth
GroundTruthErrors ground_truth_errors(const SurfaceMap& map, const GroundTruth& truth, const TriMesh& target);

}  // namespace partwise
