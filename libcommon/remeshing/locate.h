#pragma once

#include <vector>

#include "geometry/surface_index.h"
#include "mesh/part.h"

namespace partwise {

/// A part mapped onto a surface around a centre (its hull), searched by directions from that centre.
///
/// Seen from the centre the mapped part is a spherical mesh; a one-to-one map has exactly one facet behind
/// each direction. Where the map is folded there are several, and some are seen from their back.
class DomainLocator {
 public:
  /// \pre images.size() == part.mesh.vertex_count(); `part` outlives the locator
  DomainLocator(const Part& part, const Points& images, const Vec3& centre);

  /// Points of the (capped) part behind `image`, as local facets and barycentric coordinates: the solution of
  /// [p1 p2 p3] b = image - centre, scaled to sum 1. Only positively oriented facets when there are any;
  /// ascending facets; a point on an edge is found in both facets. Never empty: where no facet is hit (image
  /// at the centre), the closest point.
  std::vector<SurfacePoint> locate(const Vec3& image) const;

  /// The same point on the model that the part was cut from; a point in a cap slides from the cap's centre
  /// outward to the boundary loop.
  SurfacePoint on_model(const SurfacePoint& local) const;

 private:
  const Part& part_;
  Vec3 centre_;
  Points around_centre_;
  SurfaceIndex index_;
};

}  // namespace partwise
