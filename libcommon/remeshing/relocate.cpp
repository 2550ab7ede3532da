#include "remeshing/relocate.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "error.h"
#include "geometry/surface_index.h"
#include "remeshing/faults.h"
#include "remeshing/part_scales.h"

namespace partwise {
namespace {

struct Distances {
  double rms = 0, max = 0;
};

/// From the target's vertices to the mesh, over the target's diagonal.
Distances coverage(const MeshOnSurface& mesh) {
  const SurfaceIndex surface(mesh.points(), mesh.source().facets());
  Distances result;
  for (const Vec3& p : mesh.target().points()) {
    const double distance = surface.closest(p).distance;
    result.rms += distance * distance;
    result.max = std::max(result.max, distance);
  }
  const double diagonal = mesh.target().diagonal();
  result.rms = std::sqrt(result.rms / mesh.target().vertex_count()) / diagonal;
  result.max /= diagonal;
  return result;
}

void check(const RelocateOptions& options) {
  if (options.rounds < 0) throw InputError("the number of relocation rounds must not be negative");
  if (options.relax_sweeps < 0) throw InputError("the number of relaxation sweeps must not be negative");
  if (!(options.lambda > 0) || options.lambda > 1) {
    throw InputError("lambda is " + std::to_string(options.lambda) + "; give a number above 0 and at most 1");
  }
  if (!(options.critical.weight > 0)) throw InputError("the weight of critical points must be positive");
  if (options.registration.steps < 0)
    throw InputError("the number of registration steps must not be negative");
  if (!(options.registration.reach > 0)) throw InputError("the reach of the registration must be positive");
  if (options.gaps.rounds < 0) throw InputError("the number of rounds that close gaps must not be negative");
  if (!(options.gaps.threshold > 0)) throw InputError("the gaps to close must be wider than 0");
  if (options.mend_sweeps < 0) throw InputError("the number of mending sweeps must not be negative");
  if (!(options.fit.threshold >= 0)) throw InputError("the threshold of the fit must not be negative");
}

}  // namespace

double relocation_round(MeshOnSurface& mesh, const VertexWeights& weights, double lambda) {
  double sum = 0;
  const int count = mesh.source().vertex_count();
  for (int v = 0; v < count; ++v) {
    const Vec3 from = mesh.points()[v];
    Vec3 mean = Vec3::Zero();
    for (VertexWeights::InnerIterator it(weights, v); it; ++it) mean += it.value() * mesh.points()[it.col()];
    if (mesh.move_towards(v, from + lambda * (mean - from))) sum += (mesh.points()[v] - from).norm();
  }
  return sum / count;
}

namespace {

CompatibleMesh relocate_by_relaxation(const CompatibleMesh& mesh, const RelocateOptions& options,
                                      RelocateMetrics& metrics) {
  MeshOnSurface moving(mesh);
  const std::vector<double> scales = part_scales(mesh);
  relax_on_surface(moving, scales, options.relaxation);  // before features pin what has yet to slide
  relax_towards_registration(moving, scales, options.registration);
  std::vector<CriticalPair> pairs = fit_critical_points(moving, mesh.critical_points, options.critical);
  for (const CriticalPair& pair : pairs) moving.pin(pair.vertex);
  const VertexWeights weights = mean_value_weights(mesh.source.points(), mesh.source.facets());
  while (metrics.rounds < options.rounds) {
    ++metrics.rounds;
    const double moved = relocation_round(moving, weights, options.lambda);
    if (moved < options.convergence * mesh.target.diagonal()) break;
  }
  relax_on_surface(moving, scales, options.relaxation);
  relax(moving, options.relax_sweeps, scales);
  for (const CriticalPair& pair : pairs) moving.unpin(pair.vertex);
  close_gaps(moving, mesh, scales, pairs, options.gaps);
  pairs = meet_critical_points(moving, std::move(pairs), options.fit.least_quality);
  metrics.critical_reached = static_cast<int>(pairs.size());
  for (const CriticalPair& pair : pairs) moving.pin(pair.vertex);
  if (unfold(moving, options.unfold) > 0) {
    for (const CriticalPair& pair : pairs) moving.unpin(pair.vertex);
    unfold(moving, options.unfold);
  }
  metrics.fit_moves = fit_coverage(moving, options.fit);
  mend_faults(moving, options.mend_sweeps);
  return with_images(mesh, moving.images());
}

/// Without charts when that broke them.
CompatibleMesh relocate_by_umbrella(const CompatibleMesh& mesh, const RelocateOptions& options,
                                    RelocateMetrics& metrics) {
  const UmbrellaResult moved = relocate_by_umbrella(mesh, {.rounds = options.rounds,
                                                           .lambda = options.lambda,
                                                           .convergence = options.convergence,
                                                           .weights = options.umbrella_weights,
                                                           .critical = options.critical});
  metrics.rounds = moved.rounds;
  metrics.critical_reached = moved.critical_reached;
  CompatibleMesh result = with_images(mesh, moved.images);
  metrics.charts = check_charts(result);
  const bool broken = std::any_of(metrics.charts.begin(), metrics.charts.end(),
                                  [](const ChartFigures& chart) { return !chart.one_to_one; });
  if (broken) {
    result.charts.clear();
    result.added_vertices.clear();
    result.inverse.clear();
  }
  return result;
}

}  // namespace

Relocation relocate(const CompatibleMesh& mesh, const RelocateOptions& options) {
  check(options);
  RelocateMetrics metrics;
  metrics.critical_points = static_cast<int>(mesh.critical_points.size());
  const MeshOnSurface start(mesh);
  metrics.flipped_before = start.flipped_count();
  const Distances before = coverage(start);
  metrics.rms_distance_before = before.rms;
  metrics.max_distance_before = before.max;

  const bool relaxes = options.method == RelocateMethod::relax;
  Refined refined = refine(
      relaxes ? relocate_by_relaxation(mesh, options, metrics) : relocate_by_umbrella(mesh, options, metrics),
      options.refine);
  metrics.refine = refined.figures;
  CompatibleMesh& result = refined.mesh;
  const MeshOnSurface end(result);
  metrics.flipped_after = end.flipped_count();
  const Distances after = coverage(end);
  metrics.rms_distance_after = after.rms;
  metrics.max_distance_after = after.max;
  if (!result.charts.empty()) {
    metrics.charts = check_charts(result);
    result.inverse = inverse_map(result);
  }
  return {std::move(result), std::move(metrics)};
}

}  // namespace partwise
