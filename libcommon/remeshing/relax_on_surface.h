#pragma once

#include "remeshing/mesh_on_surface.h"

namespace partwise {

struct SurfaceRelaxationOptions {
  int iterations = 20;           ///< of Newton's method, at most; >= 0
  double least_decrease = 1e-3;  ///< relative; five iterations in a row below it end the relaxation
  double least_quality = -1;     ///< no facet gets worse than this; -1: as flat as it likes
};

/// A place of the mesh that is drawn to a point in space: weight |place - target|^2 is added to the energy.
struct PlacePull {
  SurfacePoint place;  ///< of the source
  Vec3 target = Vec3::Zero();
  double weight = 1;
};

struct SurfaceRelaxation {
  int iterations = 0;
  double energy_before = 0, energy_after = 0;  ///< over the source's (scaled) area; 2 for an isometry
};

/// Lowers the distortion of the whole map at once: Newton's method on the regularised energy of FoldoverFree,
/// every vertex in a plane that touches the target at its image, then walked over the target. What
/// vertex-wise relaxation (`relax`) needs hundreds of sweeps for, the slide of a limb along its length, takes
/// a few steps.
///
/// Pinned vertices stay. A vertex whose step would fold the map, flip one more facet of the mesh or make one
/// too flat takes a part of it or none; where many do, the energy of the whole may rise again. \param scales
/// per source facet: how much longer its edges should be on the target
SurfaceRelaxation relax_on_surface(MeshOnSurface& mesh, const std::vector<double>& scales,
                                   const SurfaceRelaxationOptions& options = {},
                                   const std::vector<PlacePull>& pulls = {});

}  // namespace partwise
