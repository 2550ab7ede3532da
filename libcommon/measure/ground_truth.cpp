#include "measure/ground_truth.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <istream>
#include <numeric>
#include <sstream>
#include <string>

#include "error.h"
#include "geometry/normals.h"
#include "measure/geodesic_search.h"

namespace partwise {
namespace {

std::string line_name(std::size_t index) {
  return "line " + std::to_string(index + 1);
}

int parse_target_vertex(const std::string& line, std::size_t index, const TriMesh& target) {
  std::istringstream words(line);
  int vertex = 0;
  std::string surplus;
  if (!(words >> vertex) || words >> surplus) {
    throw InputError(line_name(index) + " of the ground truth is \"" + line +
                     "\": write one target vertex per line, or -1");
  }
  if (vertex < kNoTruth || vertex >= target.vertex_count()) {
    throw InputError(line_name(index) + " of the ground truth names vertex " + std::to_string(vertex) +
                     " but the target has " + std::to_string(target.vertex_count()) +
                     " vertices: indices are 0-based, -1 where none is known");
  }
  return vertex;
}

std::vector<double> sorted_errors(const SurfaceMap& map, const GroundTruth& truth, const TriMesh& target) {
  std::vector<int> vertices;
  for (std::size_t v = 0; v < truth.size(); ++v) {
    if (truth[v] != kNoTruth) vertices.push_back(static_cast<int>(v));
  }
  std::vector<double> errors(vertices.size());
  tbb::enumerable_thread_specific<GeodesicSearch> searches([&] { return GeodesicSearch(target); });
  tbb::parallel_for(std::size_t{0}, vertices.size(), [&](std::size_t i) {
    errors[i] = searches.local().distance(truth[vertices[i]], map[vertices[i]]);
  });
  const std::vector<double> areas = facet_areas(target.points(), target.facets());
  const double unit = std::sqrt(std::accumulate(areas.begin(), areas.end(), 0.0));
  for (double& error : errors) error /= unit;
  std::sort(errors.begin(), errors.end());
  return errors;
}

double quantile(const std::vector<double>& sorted, double share) {
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
  return sorted[std::max<std::size_t>(rank, 1) - 1];
}

double share_below(const std::vector<double>& sorted, double limit) {
  const auto count = std::lower_bound(sorted.begin(), sorted.end(), limit) - sorted.begin();
  return static_cast<double>(count) / static_cast<double>(sorted.size());
}

}  // namespace

GroundTruth identity_truth(const TriMesh& source, const TriMesh& target) {
  if (source.vertex_count() > target.vertex_count()) {
    throw InputError("the source has " + std::to_string(source.vertex_count()) + " vertices, the target " +
                     std::to_string(target.vertex_count()) +
                     ": the identity is no ground truth for them, give a file of target vertices");
  }
  GroundTruth truth(source.vertex_count());
  std::iota(truth.begin(), truth.end(), 0);
  return truth;
}

GroundTruth read_truth(std::istream& in, const TriMesh& source, const TriMesh& target) {
  GroundTruth truth;
  std::string line;
  while (std::getline(in, line)) truth.push_back(parse_target_vertex(line, truth.size(), target));
  if (static_cast<int>(truth.size()) != source.vertex_count()) {
    throw InputError("the ground truth has " + std::to_string(truth.size()) + " lines but the source " +
                     std::to_string(source.vertex_count()) + " vertices: write one line per source vertex");
  }
  return truth;
}

GroundTruthErrors ground_truth_errors(const SurfaceMap& map, const GroundTruth& truth,
                                      const TriMesh& target) {
  const std::vector<double> errors = sorted_errors(map, truth, target);
  if (errors.empty()) throw InputError("the ground truth names no vertex: every line is -1");
  GroundTruthErrors result;
  result.vertices = static_cast<int>(errors.size());
  result.unreachable = static_cast<int>(
      std::count_if(errors.begin(), errors.end(), [](double error) { return !std::isfinite(error); }));
  result.mean = std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
  result.median = quantile(errors, 0.5);
  result.quantile_90 = quantile(errors, 0.9);
  result.quantile_99 = quantile(errors, 0.99);
  result.max = errors.back();
  result.share_below_05 = share_below(errors, 0.05);
  result.share_below_10 = share_below(errors, 0.1);
  result.share_below_25 = share_below(errors, 0.25);
  return result;
}

}  // namespace partwise
