#include "measure/surface_distance.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "error.h"
#include "geometry/normals.h"
#include "geometry/surface_index.h"
#include "measure/surface_samples.h"

namespace partwise {
namespace {

std::vector<double> distances_to(const SurfaceIndex& surface, const Points& queries) {
  std::vector<double> distances(queries.size());
  tbb::parallel_for(std::size_t{0}, queries.size(),
                    [&](std::size_t i) { distances[i] = surface.closest(queries[i]).distance; });
  return distances;
}

double largest(const std::vector<double>& values) {
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

double root_mean_square(const std::vector<double>& values) {
  if (values.empty()) return 0;
  const double sum = std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

OneSidedDistance one_sided(const TriMesh& from, const SurfaceIndex& to, int samples, std::uint64_t seed) {
  const std::vector<double> at_samples =
      distances_to(to, sample_surface(from.points(), from.facets(), samples, seed));
  OneSidedDistance result;
  result.rms = root_mean_square(at_samples);
  result.max_at_vertices = largest(distances_to(to, from.points()));
  result.max = std::max(largest(at_samples), result.max_at_vertices);
  return result;
}

double area(const TriMesh& mesh) {
  const std::vector<double> areas = facet_areas(mesh.points(), mesh.facets());
  return std::accumulate(areas.begin(), areas.end(), 0.0);
}

}  // namespace

SurfaceDistance surface_distance(const TriMesh& first, const TriMesh& second,
                                 const SurfaceDistanceOptions& options) {
  if (options.samples < 1) {
    throw InputError("cannot measure distances with " + std::to_string(options.samples) +
                     " samples: use at least 1");
  }
  const SurfaceIndex first_index(first), second_index(second);
  SurfaceDistance result;
  result.forward = one_sided(first, second_index, options.samples, options.seed);
  result.backward = one_sided(second, first_index, options.samples, options.seed + 1);
  const double first_area = area(first), second_area = area(second);
  result.rms = std::sqrt(
      (first_area * std::pow(result.forward.rms, 2) + second_area * std::pow(result.backward.rms, 2)) /
      (first_area + second_area));
  result.max = std::max(result.forward.max, result.backward.max);
  return result;
}

}  // namespace partwise
