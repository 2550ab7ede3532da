#pragma once

#include "remeshing/compatible_mesh.h"
#include "remeshing/critical_fit.h"
#include "remeshing/mesh_on_surface.h"

namespace partwise {

struct GapClosingOptions {
  int rounds = 6;            ///< of looking for gaps and moving; >= 0
  double threshold = 0.002;  ///< narrower gaps are left, over the target's diagonal; > 0
  /// A gap as wide as the threshold pulls as strongly as distortion resists when it is as long as an edge and
  /// the distortion that of an isometry; a wider one more, by the square.
  double strength = 1;
  int iterations = 2;                                   ///< of Newton's method per round
  double least_quality = MeshOnSurface::kLeastQuality;  ///< no facet gets worse than this
};

/// Closes the gaps between a compatible mesh and its target by moving all vertices over the target at once:
/// the energy of the map's distortion with, for every gap, the squared distance between the place of the mesh
/// and the target's point that the map takes there (CoverageGaps). What coverage_fit pulls one vertex onto, a
/// hoof or horn that the mesh stops short of, whole regions slide along to here.
///
/// Critical points that vertices were brought to pull like gaps of the threshold's width. Pinned vertices
/// stay; a map that is one-to-one stays so; no facet more is flipped.
/// \param start the mesh that `mesh` was made for: its charts and labels
/// \param scales see relax_on_surface
void close_gaps(MeshOnSurface& mesh, const CompatibleMesh& start, const std::vector<double>& scales,
                const std::vector<CriticalPair>& critical, const GapClosingOptions& options = {});

}  // namespace partwise
