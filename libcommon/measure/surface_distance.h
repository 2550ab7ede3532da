#pragma once

#include <cstdint>

#include "mesh/tri_mesh.h"

namespace partwise {

/// Distances from the points of one surface to another, in the units of the models.
struct OneSidedDistance {
  double rms = 0;              ///< root mean square over the surface's area
  double max = 0;              ///< over samples and vertices: a lower bound of the Hausdorff distance
  double max_at_vertices = 0;  ///< over vertices only
};

/// Distances between two surfaces both ways, in the units of the models.
struct SurfaceDistance {
  OneSidedDistance forward;   ///< from the first surface to the second
  OneSidedDistance backward;  ///< from the second to the first
  double rms = 0;             ///< over the area of both surfaces together
  double max = 0;             ///< the larger of both ways
};

struct SurfaceDistanceOptions {
  int samples = 50'000;  ///< points on each surface, besides its vertices
  std::uint64_t seed = 1;
};

/// Distance of closest points, sampled evenly by area (see sample_surface) and at all vertices.
///
/// With n samples the root mean square has a relative error of about 1/sqrt(n) at most, far less on smooth
/// surfaces. The result does not depend on the number of threads. \throws InputError when options.samples
/// < 1.
SurfaceDistance surface_distance(const TriMesh& first, const TriMesh& second,
                                 const SurfaceDistanceOptions& options = {});

}  // namespace partwise
