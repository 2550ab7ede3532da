#pragma once

#include "remeshing/mesh_on_surface.h"

namespace partwise {

struct CriticalFitOptions {
  int iterations = 5;
  double weight = 1;  ///< of Eq. (17) against the Laplacian energy; > 0
};

/// A critical point of the target and the vertex that carries it.
struct CriticalPair {
  int vertex = 0;         ///< of the compatible mesh
  int target_vertex = 0;  ///< where it belongs
};

/// Pairs every critical point with the closest corner of the nearest facet of the compatible mesh from which
/// it can be reached over the target, in the order of the list (most curved first). A vertex carries one
/// critical point at most; a point whose vertices are all taken or pinned gets none ([Wu11] 6.1.2).
std::vector<CriticalPair> pair_critical_points(const MeshOnSurface& mesh,
                                               const std::vector<CriticalPoint>& critical);

/// Pulls the paired vertices to their critical points and takes the others along smoothly: a few rounds of
/// minimising |L D|^2 + weight sum |v_i + D_i - s_i|^2 over the displacements D ([Wu11] Eq. (17) with the
/// Laplacian of the source), each followed by moves over the target. A pair that has
/// met stays. Returns the pairs that met.
///
/// Differs from [Wu11]: the Laplacian acts on displacements, so that the shape reached is kept rather than
/// smoothed, and no vertex leaves the target.
std::vector<CriticalPair> fit_critical_points(MeshOnSurface& mesh, const std::vector<CriticalPoint>& critical,
                                              const CriticalFitOptions& options = {});

/// Moves paired vertices onto their critical points where no facet gets flipped or worse than `least_quality`
/// by that. Returns the pairs that meet.
std::vector<CriticalPair> meet_critical_points(MeshOnSurface& mesh, std::vector<CriticalPair> pairs,
                                               double least_quality);

}  // namespace partwise
