#pragma once

#include <cstdint>
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

/// Where to look for gaps, besides vertices and middles of the mesh's edges.
struct CoverageSampling {
  int points = 20'000;          ///< spread evenly over each surface (sample_surface)
  bool at_least_facets = true;  ///< no fewer points than the surface has facets
  std::uint64_t mesh_seed = 7, target_seed = 7;
};

/// The places that surface_distance looks at when it measures from a compatible mesh to its target, so that
/// it finds no gap that was not found here.
CoverageSampling as_measured();

/// Finds where a compatible mesh and its target are apart, both ways.
class CoverageGaps {
 public:
  /// `target` outlives the object.
  explicit CoverageGaps(const TriMesh& target, const CoverageSampling& sampling = {});

  /// All gaps wider than `least` (units of the target), the widest first.
  ///
  /// A point of the target that is far from the mesh is missed at the place that the map takes there; without
  /// charts, at the nearest one. \pre `mesh` has the target that this object was made for
  std::vector<CoverageGap> wider_than(double least, const CompatibleMesh& mesh) const;

 private:
  int spread_on(const Facets& facets) const;

  const TriMesh& target_;
  CoverageSampling sampling_;
  SurfaceIndex index_;
  Points places_;
  double area_ = 0;
};

}  // namespace partwise
