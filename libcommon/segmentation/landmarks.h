#pragma once

#include <string>
#include <vector>

#include "mesh/segmentation.h"
#include "segmentation/surface_places.h"

namespace partwise {

/// The sketch's markers on the surface, in its order. \throws InputError naming the marker.
std::vector<Marker> place_markers(const Sketch& sketch, SurfacePlaces& places);

/// The sketch's anchors, each snapped to the nearest free vertex of the curves between its two parts.
///
/// The one nearest to its curve chooses first; two never share a vertex.
/// \throws InputError naming the anchor when its parts share no boundary, or it has no vertices left.
std::vector<Anchor> place_anchors(const TriMesh& mesh, const Segmentation& segmentation, const Sketch& sketch,
                                  SurfacePlaces& places);

/// One sentence per closed curve between two parts with fewer than 2 anchors on it.
std::vector<std::string> unanchored_curves(const Segmentation& segmentation,
                                           const std::vector<Anchor>& anchors);

/// Parts a marker lies in: one, or several when it lies on their boundary; ascending.
std::vector<int> parts_at(const TriMesh& mesh, const Segmentation& segmentation, const SurfacePoint& point);

}  // namespace partwise
