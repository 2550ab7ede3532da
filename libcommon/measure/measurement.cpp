#include "measure/measurement.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <numeric>

#include "error.h"
#include "geometry/normals.h"
#include "measure/degenerate_facets.h"
#include "measure/flipped_facets.h"
#include "measure/marker_errors.h"
#include "measure/self_intersections.h"

namespace partwise {
namespace {

int intersection_count(const Points& points, const Facets& facets) {
  return static_cast<int>(self_intersections(points, facets).size());
}

SelfIntersectionCounts count_self_intersections(const CompatibleMesh& mesh) {
  SelfIntersectionCounts counts;
  tbb::parallel_invoke(
      [&] { counts.compatible = intersection_count(mesh.points, mesh.source.facets()); },
      [&] { counts.source = intersection_count(mesh.source.points(), mesh.source.facets()); },
      [&] { counts.target = intersection_count(mesh.target.points(), mesh.target.facets()); });
  return counts;
}

bool has_area(const Points& points, const Facets& facets) {
  const std::vector<double> areas = facet_areas(points, facets);
  return std::accumulate(areas.begin(), areas.end(), 0.0) > 0;
}

double largest_map_gap(const CompatibleMesh& mesh) {
  const Points images = mesh.map.positions(mesh.target);
  double largest = 0;
  for (std::size_t v = 0; v < images.size(); ++v) {
    largest = std::max(largest, (mesh.points[v] - images[v]).norm());
  }
  return largest;
}

std::vector<MarkerError> named_marker_errors(const CompatibleMesh& mesh, double diagonal) {
  const std::vector<double> errors =
      marker_errors(mesh.markers, mesh.source.facets(), mesh.points, mesh.target);
  std::vector<MarkerError> named;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    named.push_back({mesh.markers[i].name, errors[i] / diagonal});
  }
  return named;
}

}  // namespace

Measurement measure(const CompatibleMesh& mesh, const SurfaceDistanceOptions& options,
                    const std::optional<GroundTruth>& truth) {
  const Facets& facets = mesh.source.facets();
  Measurement result;
  result.target_diagonal = mesh.target.diagonal();
  if (!(result.target_diagonal > 0)) {
    throw InputError("the target's vertices are all in one place: nothing can be measured against it");
  }
  result.source_facets = mesh.source.facet_count();
  result.target_facets = mesh.target.facet_count();
  result.parts = static_cast<int>(mesh.part_names.size());
  result.distance = surface_distance(mesh.source.with_points(mesh.points), mesh.target, options);
  result.map_gap = largest_map_gap(mesh);
  result.flipped_facets = static_cast<int>(flipped_facets(mesh.points, facets, mesh.map, mesh.target).size());
  result.self_intersections = count_self_intersections(mesh);
  result.degenerate_facets = static_cast<int>(degenerate_facets(mesh.points, facets).size());
  if (has_area(mesh.source.points(), facets) && has_area(mesh.points, facets)) {
    result.distortion = distortion(mesh.source.points(), mesh.points, facets);
  }
  result.marker_errors = named_marker_errors(mesh, result.target_diagonal);
  result.certificate = certify(mesh);
  if (truth) result.truth = ground_truth_errors(mesh.map, *truth, mesh.target);
  return result;
}

}  // namespace partwise
