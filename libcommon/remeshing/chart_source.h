#pragma once

#include "remeshing/compatible_mesh.h"

namespace partwise {

/// The source of a compatible mesh with the added vertices of its charts.
struct RefinedSource {
  EdgeSplitMesh split;
  std::vector<int> labels;  ///< per facet of split.mesh: part
  std::vector<SurfacePoint>
      images;  ///< per vertex of split.mesh: point of the target; facet -1: not known yet
};

RefinedSource refine_source(const CompatibleMesh& mesh);

/// The source's side of a chart: a piece of the refined source, on the same sphere as the target's.
struct ChartSource {
  Part piece;  ///< of RefinedSource::split.mesh
  Points directions;
};

/// Lays the source's piece out by the images of its vertices; the centre of each cap has the direction of the
/// target's cap over the loop that the images of its own loop lie on.
/// \throws InputError naming the vertex whose image lies outside the target's piece, or on a boundary where
/// it
///         should not; or saying that the loops do not correspond
ChartSource lay_out(const RefinedSource& source, const std::vector<bool>& inside, const ChartTarget& target);

/// How far the images of a loop of the source's piece lie from each other along the target's loop, in the
/// latter's edges: one step per edge of the loop, all positive, adding up to the number of the target's
/// edges. \throws InputError naming the vertex where that is not so: the loops do not correspond one-to-one
std::vector<double> loop_steps(const ChartSource& source, const std::vector<SurfacePoint>& images,
                               std::size_t loop, const ChartTarget& target);

}  // namespace partwise
