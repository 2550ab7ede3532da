#pragma once

#include <string>
#include <vector>

#include "remeshing/compatible_mesh.h"

namespace partwise {

/// A number at every vertex of a surface, and how to show it.
struct SurfaceField {
  std::string meaning;       ///< with its unit, for people
  double low = 0, high = 1;  ///< ends of the colour map; what is beyond looks like the end
  bool logarithmic = false;  ///< equal steps of colour are equal factors
  Points points;
  Facets facets;
  std::vector<double> values;  ///< per vertex

  /// 0 at `low` and below, 1 at `high` and above.
  double share(double value) const;
};

/// Distance of the target's vertices to the compatible mesh, over the target's diagonal: what the mesh
/// misses. Shown on the target, from 0 to 1 %. \throws InputError when the target is a point
SurfaceField distance_field(const CompatibleMesh& mesh);

/// Symmetric Dirichlet energy of the facets around a vertex, mean over the source's area (see Distortion).
/// Shown on the compatible mesh, from 4 (isometry) to 40. \throws InputError when a surface has no area
SurfaceField distortion_field(const CompatibleMesh& mesh);

/// What is wrong around a vertex of the compatible mesh: 2 beside a facet that faces against the target, 1
/// beside one that intersects another, 0 else.
SurfaceField fold_field(const CompatibleMesh& mesh);

}  // namespace partwise
