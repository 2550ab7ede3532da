#include "remeshing/one_to_one_map.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "error.h"
#include "geometry/convex_hull.h"
#include "mapping/parallel_parts.h"
#include "mapping/progressive_embedding.h"
#include "mapping/untangle_on_sphere.h"
#include "measure/hull_folds.h"
#include "remeshing/chart_source.h"
#include "remeshing/chart_vertices.h"
#include "remeshing/locate.h"

namespace partwise {
namespace {

constexpr double kCapWeight = 0.1;  ///< how much distortion counts in caps, which no one sees

std::vector<ChartTarget> targets_of(const CompatibleMesh& mesh) {
  std::vector<ChartTarget> targets;
  for (const Chart& chart : mesh.charts) targets.emplace_back(mesh.target, mesh.target_labels, chart);
  return targets;
}

/// The whole target on one sphere, if both surfaces are spheres with the same number of holes.
std::optional<Chart> whole_chart(const CompatibleMesh& mesh) {
  Chart chart;
  chart.parts.resize(mesh.part_names.size());
  std::iota(chart.parts.begin(), chart.parts.end(), 0);
  const Part source = extract_piece(mesh.source, std::vector<bool>(mesh.source.facet_count(), true));
  const Part target = extract_piece(mesh.target, std::vector<bool>(mesh.target.facet_count(), true));
  if (!source.is_sphere() || !target.is_sphere() || source.loops.size() != target.loops.size()) return {};
  std::vector<double> weights(target.mesh.vertex_count(), 1.0);
  for (const int cap : target.cap_vertices) weights[cap] = kCapWeight;
  try {
    chart.directions = embed_progressively(target.mesh, weights);
  } catch (const ComputationError&) {
    return {};  // below double precision; the parts' own hulls may still do
  }
  return chart;
}

/// Vertices of the refined source that must not move: markers, and with `curves` all that lie between parts.
std::vector<bool> held_vertices(const CompatibleMesh& mesh, const RefinedSource& source, bool curves) {
  std::vector<bool> held(source.split.mesh.vertex_count(), false);
  for (const MarkerPair& marker : mesh.markers) {
    if (const std::optional<int> v = vertex_at(mesh.source, marker.source)) held[*v] = true;
  }
  if (!curves) return held;
  std::vector<int> part(held.size(), -1);
  for (int f = 0; f < source.split.mesh.facet_count(); ++f) {
    for (const int v : source.split.mesh.facet(f)) {
      if (part[v] >= 0 && part[v] != source.labels[f]) held[v] = true;
      part[v] = source.labels[f];
    }
  }
  return held;
}

/// \param images of the source's vertices, then of those added on its edges
CompatibleMesh with_refined_images(const CompatibleMesh& mesh, const std::vector<SurfacePoint>& images) {
  const auto originals = static_cast<std::ptrdiff_t>(mesh.points.size());
  CompatibleMesh result = with_images(mesh, {images.begin(), images.begin() + originals});
  for (std::size_t i = 0; i < result.added_vertices.size(); ++i) {
    result.added_vertices[i].image = images[mesh.points.size() + i];
  }
  return result;
}

/// A map whose markers at source vertices are where they belong, whatever folds that makes.
struct PlacedMarkers {
  CompatibleMesh mesh;
  std::vector<std::string> names;  ///< of those that were elsewhere
};

PlacedMarkers with_markers_in_place(const CompatibleMesh& mesh) {
  const double near = 1e-9 * mesh.target.diagonal();
  PlacedMarkers placed{mesh, {}};
  std::vector<SurfacePoint> images = mesh.map.images();
  for (const MarkerPair& marker : mesh.markers) {
    const std::optional<int> v = vertex_at(mesh.source, marker.source);
    if (!v || (mesh.points[*v] - position(mesh.target, marker.target)).norm() <= near) continue;
    images[*v] = marker.target;
    placed.names.push_back(marker.name);
  }
  placed.mesh = with_refined_images(mesh, images);
  return placed;
}

/// New images of the vertices of one chart that had to move.
struct Moves {
  std::vector<std::pair<int, SurfacePoint>> images;  // vertex of the refined source
  int folds_before = 0;
  std::string reason;
};

Moves unfold_chart(const RefinedSource& source, const std::vector<bool>& inside, const ChartTarget& target,
                   const std::vector<bool>& held) {
  ChartSource side = lay_out(source, inside, target);
  const Part& piece = side.piece;
  const std::size_t originals = source.images.size() - source.split.points.size();
  std::vector<bool> fixed(side.directions.size(), false), is_new(side.directions.size(), false);
  for (std::size_t v = 0; v < fixed.size(); ++v) {
    if (piece.is_cap_vertex(static_cast<int>(v))) continue;
    const int of_model = piece.model_vertex[v];
    fixed[v] = held[of_model];
    is_new[v] = source.images[of_model].facet < 0;
    if (!is_new[v]) continue;
    const EdgePoint& place = source.split.points[of_model - originals];
    side.directions[v] = side.directions[piece.local_vertex(place.a)].stableNormalized() +
                         side.directions[piece.local_vertex(place.b)].stableNormalized();
  }
  for (const std::vector<int>& loop : piece.loops) {
    for (const int v : loop) fixed[v] = true;
  }
  for (const int v : piece.cap_vertices) fixed[v] = true;

  Moves moves;
  const UntangledMap unfolded = untangle_on_sphere(piece.mesh, side.directions, fixed);
  moves.folds_before = unfolded.folds_before;
  const DomainLocator locator(target.piece(), target.directions(), Vec3::Zero());
  for (std::size_t v = 0; v < fixed.size(); ++v) {
    if (fixed[v] || !(unfolded.moved[v] || is_new[v])) continue;
    const SurfacePoint local = locator.locate(unfolded.images[v]).front();
    moves.images.emplace_back(piece.model_vertex[v], locator.on_model(local));
  }
  return moves;
}

ChartFigures check_chart(const Chart& chart, const RefinedSource& source, const ChartTarget& target,
                         const std::vector<bool>& inside) {
  ChartFigures figures;
  figures.parts = chart.parts;
  try {
    const ChartSource side = lay_out(source, inside, target);
    const HullFolds folds = hull_folds(side.directions, side.piece.mesh.facets(), Vec3::Zero());
    figures.folds = folds.count();
    figures.degree = folds.degree;
    if (!side.piece.is_sphere() || !target.piece().is_sphere()) {
      figures.reason = "it has a handle or several components; cut it into more parts";
    } else if (!hull_folds(target.directions(), target.piece().mesh.facets(), Vec3::Zero()).one_to_one()) {
      figures.reason = "the target's own map onto its hull folds";
    } else if (!folds.one_to_one()) {
      figures.reason = std::to_string(folds.count()) + " facets stay folded";
    } else {
      for (std::size_t i = 0; i < side.piece.loops.size(); ++i) loop_steps(side, source.images, i, target);
      figures.one_to_one = true;
    }
  } catch (const InputError& error) {
    figures.reason = error.what();
  }
  return figures;
}

/// Lays the mesh out on its charts and unfolds it there.
OneToOneMap unfold_on(CompatibleMesh mesh, bool hold_curves) {
  OneToOneMap result{std::move(mesh), {}, 0, hold_curves};
  CompatibleMesh& laid = result.mesh;
  const std::vector<ChartTarget> targets = targets_of(laid);
  const int count = static_cast<int>(targets.size());
  std::optional<RefinedSource> refined;
  try {
    add_chart_vertices(laid, targets);
    refined = refine_source(laid);
  } catch (const InputError& error) {
    for (const Chart& chart : laid.charts)
      result.charts.push_back({chart.parts, 0, 0, 0, false, error.what()});
    return result;
  }
  RefinedSource& source = *refined;
  const std::vector<bool> held = held_vertices(laid, source, hold_curves);
  std::vector<Moves> moves(count);
  for_each_part(count, [&](int k) {
    try {
      moves[k] = unfold_chart(source, facets_of(laid.charts[k], source.labels), targets[k], held);
    } catch (const InputError& error) {
      moves[k].reason = error.what();
    }
  });
  for (const Moves& of_chart : moves) {
    result.moved_vertices += static_cast<int>(of_chart.images.size());
    for (const auto& [vertex, image] : of_chart.images) source.images[vertex] = image;
  }
  laid = with_refined_images(laid, source.images);
  result.charts = check_charts(laid);
  for (int k = 0; k < count; ++k) {
    result.charts[k].folds_before = moves[k].folds_before;
    if (!moves[k].reason.empty()) result.charts[k].reason = moves[k].reason;
  }
  return result;
}

bool all_one_to_one(const std::vector<ChartFigures>& charts) {
  return std::all_of(charts.begin(), charts.end(), [](const ChartFigures& c) { return c.one_to_one; });
}

}  // namespace

std::vector<Chart> charts_of_parts(const HullMap& target) {
  std::vector<Chart> charts;
  for (std::size_t k = 0; k < target.images.size(); ++k) {
    Chart chart{{static_cast<int>(k)}, target.images[k]};
    const Vec3 centre = hull_centre(target.hulled.hulls[k]);
    for (Vec3& direction : chart.directions) direction -= centre;
    charts.push_back(std::move(chart));
  }
  return charts;
}

std::vector<ChartFigures> check_charts(const CompatibleMesh& mesh) {
  const std::vector<ChartTarget> targets = targets_of(mesh);
  const RefinedSource source = refine_source(mesh);
  std::vector<ChartFigures> figures(targets.size());
  for_each_part(static_cast<int>(targets.size()), [&](int k) {
    figures[k] = check_chart(mesh.charts[k], source, targets[k], facets_of(mesh.charts[k], source.labels));
  });
  return figures;
}

std::vector<SurfacePoint> inverse_map(const CompatibleMesh& mesh) {
  const RefinedSource source = refine_source(mesh);
  std::vector<SurfacePoint> inverse(mesh.target.vertex_count());
  for (const Chart& chart : mesh.charts) {
    const ChartTarget target(mesh.target, mesh.target_labels, chart);
    const ChartSource side = lay_out(source, facets_of(chart, source.labels), target);
    const DomainLocator locator(side.piece, side.directions, Vec3::Zero());
    for (int local = 0; local < target.piece().mesh.vertex_count(); ++local) {
      const int v = target.piece().model_vertex[local];
      if (v < 0 || inverse[v].facet >= 0) continue;
      const SurfacePoint found = locator.locate(target.directions()[local]).front();
      inverse[v] = source.split.on_original(mesh.source, locator.on_model(found));
    }
  }
  return inverse;
}

OneToOneMap make_one_to_one(const CompatibleMesh& mesh, const std::vector<Chart>& part_charts) {
  std::vector<OneToOneMap> tries;
  auto succeeds_on = [&](const std::vector<Chart>& charts, const CompatibleMesh& from, bool hold_curves) {
    CompatibleMesh start = from;
    start.charts = charts;
    tries.push_back(unfold_on(std::move(start), hold_curves));
    return all_one_to_one(tries.back().charts);
  };
  auto succeeds_as_whole = [&](const Chart& whole, const CompatibleMesh& from) {
    return succeeds_on({whole}, from, true) || succeeds_on({whole}, from, false);
  };
  const std::optional<Chart> whole = whole_chart(mesh);
  const PlacedMarkers placed = with_markers_in_place(mesh);
  const bool done_with_markers = whole && !placed.names.empty() && succeeds_as_whole(*whole, placed.mesh);
  if (done_with_markers) tries.back().placed_markers = placed.names;
  const bool done =
      done_with_markers || (whole && succeeds_as_whole(*whole, mesh)) || succeeds_on(part_charts, mesh, true);
  if (done) {
    tries.back().mesh.inverse = inverse_map(tries.back().mesh);
  } else {
    tries.back().mesh = mesh;
    tries.back().moved_vertices = 0;
  }
  return std::move(tries.back());
}

}  // namespace partwise
