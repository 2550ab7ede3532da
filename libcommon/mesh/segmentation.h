#pragma once

#include <string>
#include <vector>

#include "mesh/surface_point.h"

namespace partwise {

/// The outside of a mesh with boundary, where a part index is expected.
inline constexpr int kOutside = -1;

/// A maximal chain of edges between the same two parts (or a part and the outside of an open mesh).
///
/// Walking along `vertices`, facets of `left` lie on the left and facets of `right` on the right;
/// left < right, or right == kOutside. A closed curve does not repeat its first vertex; an open one runs from
/// cross point to cross point.
struct BoundaryCurve {
  int left = 0;
  int right = kOutside;
  bool closed = false;
  std::vector<int> vertices;
  double length = 0;  ///< in the units of the model
};

/// A vertex where N >= 3 parts meet (the outside counts as one), in cyclic order around it.
struct CrossPoint {
  int vertex = 0;
  std::vector<int> parts;
};

/// A partition of a mesh's facets into named, connected parts whose boundaries are simple curves of edges.
struct Segmentation {
  std::vector<std::string> names;  ///< one per part
  std::vector<int> labels;         ///< per facet, the part it belongs to, 0 <= label < names.size()
  std::vector<BoundaryCurve> curves;
  std::vector<CrossPoint> cross_points;

  int part_count() const { return static_cast<int>(names.size()); }
};

/// A named landmark, paired with the landmark of the same name on another model.
struct Marker {
  std::string name;
  SurfacePoint point;
};

/// A named vertex on a boundary curve, paired by name with another model's.
struct Anchor {
  std::string name;
  int part_a = 0;
  int part_b = 0;
  int vertex = 0;
  double snap_distance = 0;  ///< from where the user put it to the curve vertex, in units of the model
  bool proposed = false;     ///< chosen by the program, not by the user
};

/// How far a part is from its convex hull: a hint whether to decompose it further ([Wu11] 4.2).
struct Concavity {
  double largest = 0;  ///< largest distance of a part vertex to its hull over the model's diagonal
  double mean = 0;     ///< mean of these distances over the model's diagonal
  int vertex = -1;     ///< where it is largest
};

/// A mesh with everything that a user's sketch says of it.
struct SegmentedModel {
  TriMesh mesh;
  Segmentation segmentation;
  std::vector<Marker> markers;
  std::vector<Anchor> anchors;
  std::vector<Concavity> concavity;  ///< one per part; none when it was not measured
};

/// Index of the part called `name`, or -1.
int part_index(const Segmentation& segmentation, const std::string& name);

/// Traces the boundaries of a labelling: curves, cross points.
///
/// Curves come in a fixed order (by parts, then by smallest vertex); a closed curve starts at its smallest
/// vertex, so the result does not depend on how the labelling was found.
/// \throws InputError naming vertex and part when a part is empty, not connected or pinched (its facets at a
///         vertex form more than one fan).
Segmentation trace_boundaries(const TriMesh& mesh, std::vector<std::string> names, std::vector<int> labels);

/// The same where connectivity needs no check, which takes most of the time.
/// \pre every part is connected and has facets, every label is a part's
Segmentation trace_connected_parts(const TriMesh& mesh, std::vector<std::string> names,
                                   std::vector<int> labels);

}  // namespace partwise
