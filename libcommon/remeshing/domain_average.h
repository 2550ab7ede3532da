#pragma once

#include "mapping/domains.h"
#include "remeshing/reconstruct.h"

namespace partwise {

/// Averages positions of a target part over the neighbourhood of a point of its hull domain ([Wu11] 5.3).
class DomainAverage {
 public:
  /// `part` mapped to `images` on `hull`; all outlive this object. `radius` as in ReconstructOptions.
  DomainAverage(const Part& part, const Points& images, const ConvexHull& hull, Coordinates coordinates,
                double radius);

  /// Weighted average of the part's vertices whose images are within the radius of `image`, connected to
  /// `facet` (local); the point `located` of that facet when there are none.
  Vec3 at(const Vec3& image, const SurfacePoint& located) const;

 private:
  const Part& part_;
  const Points& images_;
  double radius_;
  Points positions_;  ///< per local vertex: where its coordinates put it
};

}  // namespace partwise
