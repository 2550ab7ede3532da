#pragma once

#include <string>
#include <vector>

#include "geometry/convex_hull.h"
#include "mesh/part.h"

/// The states of a model between the stages of the pipeline; each stage takes one and returns the next.
namespace partwise {

/// A segmented model with a convex hull around every part (stage `hull`).
struct HulledModel {
  SegmentedModel model;
  std::vector<Part> parts;        ///< one per part of the segmentation
  std::vector<ConvexHull> hulls;  ///< one per part
};

/// Every (capped) part mapped onto its own convex hull: Q_k in [Wu11] (stage `map-to-hull`).
struct HullMap {
  HulledModel hulled;
  std::vector<Points> images;  ///< per part, per local vertex: position on the part's hull
};

/// Where a boundary vertex of the source lies on the target's boundary: on the edge (a, b), at a + fraction
/// (b - a); a == b when it lies at a vertex.
struct BoundaryPlacement {
  int source_vertex = 0;
  int target_a = 0;
  int target_b = 0;
  double fraction = 0;
};

/// A landmark known on both models.
struct MarkerPair {
  std::string name;
  SurfacePoint source;
  SurfacePoint target;
};

/// The source's parts mapped onto the target's hulls: Q^st_k in [Wu11] (stage `hull-to-hull`).
///
/// Parts are indexed as in the target; source part k of the target's order is `source_parts[k]`.
struct CrossMap {
  SegmentedModel source;
  HullMap target;
  std::vector<Part> source_parts;  ///< in the target's order of parts
  std::vector<Points>
      images;  ///< per part, per local vertex of source_parts[k]: position on the target's hull
  std::vector<BoundaryPlacement> boundary;  ///< one per source vertex on a boundary curve, ascending
  std::vector<MarkerPair> markers;
};

}  // namespace partwise
