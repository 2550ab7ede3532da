#include "remeshing/gap_closing.h"

#include <cmath>

#include "geometry/normals.h"
#include "remeshing/coverage_gaps.h"
#include "remeshing/relax_on_surface.h"

namespace partwise {

void close_gaps(MeshOnSurface& mesh, const CompatibleMesh& start, const std::vector<double>& scales,
                const std::vector<CriticalPair>& critical, const GapClosingOptions& options) {
  if (options.rounds == 0) return;
  const CoverageGaps search(start.target);
  const double threshold = options.threshold * start.target.diagonal();
  double area = 0;
  for (const double facet : facet_areas(start.target.points(), start.target.facets())) area += facet;
  const double squared_edge = 4 / std::sqrt(3.0) * area / start.source.facet_count();  // of an even mesh
  for (int round = 0; round < options.rounds; ++round) {
    const std::vector<CoverageGap> gaps = search.wider_than(threshold, with_images(start, mesh.images()));
    if (gaps.empty()) break;
    std::vector<PlacePull> pulls;
    for (const CoverageGap& gap : gaps) {
      const double excess = std::pow(gap.distance / threshold, 2);
      pulls.push_back(
          {gap.place, position(start.target, gap.goal), options.strength * gap.area / squared_edge * excess});
    }
    for (const CriticalPair& pair : critical) {
      pulls.push_back({vertex_point(start.source, pair.vertex), start.target.point(pair.target_vertex),
                       options.strength * area / start.source.vertex_count() / squared_edge});
    }
    relax_on_surface(mesh, scales, {.iterations = options.iterations, .least_quality = options.least_quality},
                     pulls);
  }
}

}  // namespace partwise
