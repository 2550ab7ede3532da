#pragma once

#include <vector>

#include "mapping/domains.h"
#include "remeshing/two_way_map.h"

namespace partwise {

/// Which way something is carried between the source and the target of a map.
enum class Direction { to_target, to_source };

/// A facet of the model that gives, and its share (positive, together 1).
struct FacetShare {
  int facet = 0;
  double share = 1;
};

/// Per facet of the model that receives: the facets of the other model that correspond to it, ascending.
using FacetCorrespondence = std::vector<std::vector<FacetShare>>;

/// Where points of a facet lie that stand for equal shares of its area, as barycentric coordinates.
std::vector<Vec3> facet_samples();

/// The points of the giving model that the samples of every receiving facet come from.
std::vector<std::vector<SurfacePoint>> sample_origins(const CompatibleMesh& mesh, const TwoWayMap& map,
                                                      Direction direction);

/// The exact correspondence: facets by how many of the samples they hold.
FacetCorrespondence exact_correspondence(const std::vector<std::vector<SurfacePoint>>& sample_origins);

/// The correspondence of [Wu11] (Applications): on the common hulls, the facets of the same part whose
/// centroids lie within `threshold` (over the diagonal of the part's hull) of each other; many-to-many, equal
/// shares. Where there is none, the facet with the nearest centroid, so that every facet has one.
FacetCorrespondence hull_correspondence(const CrossMap& map, double threshold, Direction direction);

}  // namespace partwise
