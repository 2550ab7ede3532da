#pragma once

#include <string>
#include <vector>

#include "remeshing/compatible_mesh.h"

namespace partwise {

/// How one chart came out.
struct ChartFigures {
  std::vector<int> parts;
  int folds_before = 0;     ///< facets of the source not positively oriented at the start
  int folds = 0;            ///< in the end, by the exact predicate
  double degree = 0;        ///< how often the source's side covers the sphere
  bool one_to_one = false;  ///< no folds and degree 1, on both sides; boundaries on boundaries
  std::string reason;       ///< why not, for people; empty when it is
};

/// A compatible mesh whose map is one-to-one, or as near as it came.
struct OneToOneMap {
  CompatibleMesh mesh;  ///< with charts when all of them are one-to-one, else without
  std::vector<ChartFigures> charts;
  int moved_vertices = 0;   ///< that had to move for it
  bool curves_held = true;  ///< false: source vertices left the boundary curves between parts for it
  std::vector<std::string> placed_markers = {};  ///< that the given map had elsewhere

  bool one_to_one() const { return !mesh.charts.empty(); }
};

/// Makes the map of the whole surface one-to-one, and proves it.
///
/// Parts that are mapped one by one without a fold still make a map that folds at their seams: a facet with
/// two corners on a seam cuts its bends short. So when both surfaces are spheres once their boundaries are
/// capped, the target is embedded as a whole (embed_progressively), the source is carried over by its
/// images, and the vertices around folds move until none is left; markers and the mesh's own boundary stay,
/// curves between parts as long as that succeeds. A marker that is not where it belongs, because the boundary
/// of its part is in the way, is first put there: on the whole surface nothing need be in its way. Where that
/// leaves folds, the map is made one-to-one without. Other surfaces are taken part by part on the parts'
/// hulls, seams held: the target's vertices there are added to the source, so that both boundaries are one.
///
/// \param part_charts one chart per part, see charts_of_parts
/// \pre mesh has no charts yet
OneToOneMap make_one_to_one(const CompatibleMesh& mesh, const std::vector<Chart>& part_charts);

/// Every part of the target on its own hull, seen from the hull's centre.
std::vector<Chart> charts_of_parts(const HullMap& target);

/// What the charts of a mesh are worth now, by the exact predicate.
std::vector<ChartFigures> check_charts(const CompatibleMesh& mesh);

/// Per target vertex: the point of the source that the charts map there. \pre charts that are one-to-one
std::vector<SurfacePoint> inverse_map(const CompatibleMesh& mesh);

}  // namespace partwise
