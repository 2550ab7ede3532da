#pragma once

#include <vector>

#include "mapping/domains.h"
#include "mesh/surface_point.h"
#include "remeshing/chart.h"

namespace partwise {

/// A vertex that carries a feature of a surface ([Wu11] 6.1).
struct CriticalPoint {
  int vertex = 0;
  double curvature = 0;  ///< K of Eq. (16), per unit of area
  double radius = 0;     ///< of its local region, in units of the model
  /// Vertices of its local region that are in no earlier one, ascending; every vertex is in one region.
  std::vector<int> region = {};
};

/// How a source with added vertices came from the one that was read. The surface is the same.
struct SourceRefinement {
  Facets original_facets;              ///< over the source's first vertices; empty when nothing was added
  std::vector<SurfacePoint> vertices;  ///< per added vertex, the source's last ones: point of the original
  std::vector<int> parent_facet;       ///< per source facet: the original facet that it is a piece of

  bool is_empty() const { return original_facets.empty(); }
};

/// The compatible mesh M^t_s: the source's connectivity with the target's shape (stages `reconstruct` to
/// `relocate`).
struct CompatibleMesh {
  TriMesh source;
  TriMesh target;
  Points points;                   ///< per source vertex; within rounding of the target's surface
  SurfaceMap map;                  ///< per source vertex: the point of the target it lies on
  std::vector<int> source_labels;  ///< per source facet: part
  std::vector<int> target_labels;  ///< per target facet: part (same indices as the source's)
  std::vector<std::string> part_names;
  std::vector<MarkerPair> markers;
  std::vector<CriticalPoint> critical_points;  ///< of the target; empty before `critical-points`

  /// Where the map is one-to-one: spheres on which both surfaces are laid out piece by piece without a fold.
  /// Together the pieces are everything. Empty when that could not be had.
  std::vector<Chart> charts = {};
  std::vector<AddedVertex> added_vertices = {};  ///< of the source's side of the charts
  std::vector<SurfacePoint> inverse = {};  ///< with charts: per target vertex, the point of the source there
  SourceRefinement refinement = {};        ///< of the source, which is the refined one everywhere else
};

/// The mesh with its vertices at other points of the target. Its inverse map is not made anew.
/// \throws InputError as SurfaceMap
CompatibleMesh with_images(const CompatibleMesh& mesh, const std::vector<SurfacePoint>& images);

}  // namespace partwise
