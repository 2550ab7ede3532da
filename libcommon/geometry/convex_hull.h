#pragma once

#include <vector>

#include "mesh/types.h"

namespace partwise {

/// Convex hull of a set of points: outward oriented triangles over the extreme points alone.
///
/// A flat side with more than three corners is cut into triangles, so neighbouring facets may be coplanar.
struct ConvexHull {
  Points points;                 ///< in the order of the input
  Facets facets;                 ///< each starts at its smallest vertex; ascending
  std::vector<int> part_vertex;  ///< per hull vertex: index of the input point (the part's vertex) that it is
};

/// Convex hull by exact predicates; its shape does not depend on the order of the points.
///
/// Points inside a flat side or an edge of the hull are no hull vertices; of equal points the first is.
/// \pre finite coordinates
/// \throws InputError when fewer than 4 points are distinct or all lie in one plane.
ConvexHull convex_hull(const Points& points);

/// Centroid of the volume inside the hull, a point from which the whole surface is visible.
/// \throws ComputationError when the hull is so thin that rounding leaves no such point.
Vec3 hull_centre(const ConvexHull& hull);

/// Per point: distance to the surface of the hull, >= 0, in the units of the model. Quick for the many points
/// inside, whose nearest plane is sought; exact up to the height of sliver facets (1e-7 of their length).
std::vector<double> distances_to_hull(const ConvexHull& hull, const Points& points);

}  // namespace partwise
