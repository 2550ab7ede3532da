#pragma once

#include <optional>
#include <string>
#include <vector>

#include "measure/certificate.h"
#include "measure/distortion.h"
#include "measure/ground_truth.h"
#include "measure/surface_distance.h"
#include "remeshing/compatible_mesh.h"

namespace partwise {

/// Pairs of intersecting facets, see self_intersections.
struct SelfIntersectionCounts {
  int compatible = 0;
  int source = 0;
  int target = 0;
};

/// How far a marker is from its place, over the target's diagonal.
struct MarkerError {
  std::string name;
  double error = 0;
};

/// Everything about a compatible mesh that can be measured on the mesh itself. Distances are in the units of
/// the target.
struct Measurement {
  int source_facets = 0;
  int target_facets = 0;
  int parts = 0;
  double target_diagonal = 0;
  SurfaceDistance distance;  ///< forward from the compatible mesh to the target
  double map_gap = 0;        ///< largest distance of a vertex to its image under the map
  int flipped_facets = 0;
  SelfIntersectionCounts self_intersections;
  int degenerate_facets = 0;
  std::optional<Distortion>
      distortion;  ///< of the source's facets to the compatible mesh's; none without area
  std::vector<MarkerError> marker_errors;
  std::optional<GroundTruthErrors> truth;
  Certificate certificate;  ///< whether the map is one-to-one, recomputed
};

/// \pre truth, when given, fits the meshes
/// \throws InputError when the target is a point or options do not fit (see surface_distance)
Measurement measure(const CompatibleMesh& mesh, const SurfaceDistanceOptions& options = {},
                    const std::optional<GroundTruth>& truth = std::nullopt);

}  // namespace partwise
