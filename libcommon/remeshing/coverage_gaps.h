#pragma once

#include <vector>

#include "geometry/surface_index.h"
#include "remeshing/compatible_mesh.h"

namespace partwise {

/// A place of the source whose image is too far from the target, or the target's point there from the image.
struct CoverageGap {
  double distance = 0;  ///< in units of the target
  SurfacePoint place;   ///< of the source
  SurfacePoint goal;    ///< of the target: where the mesh should be
  double area = 0;      ///< what the place stands for among all that were looked at, in units^2 of the target
};

/// Finds where a compatible mesh and its target are apart, both ways: at vertices and at points spread evenly
/// over the area, as many as facets (and no fewer than 20,000); of the mesh also at middles of edges.
class CoverageGaps {
 public:
  /// `target` outlives the object.
  explicit CoverageGaps(const TriMesh& target);

  /// All gaps wider than `least` (units of the target), the widest first.
  ///
  /// A point of the target that is far from the mesh is missed at the place that the map takes there; without
  /// charts, at the nearest one. \pre `mesh` has the target that this object was made for
  std::vector<CoverageGap> wider_than(double least, const CompatibleMesh& mesh) const;

 private:
  const TriMesh& target_;
  SurfaceIndex index_;
  Points places_;
  double area_ = 0;
};

}  // namespace partwise
