#include "remeshing/two_way_map.h"

#include <optional>
#include <utility>

#include "geometry/surface_index.h"
#include "remeshing/chart_source.h"
#include "remeshing/locate.h"

namespace partwise {
namespace {

/// One chart with both of its sides, searchable.
struct SearchableChart {
  ChartTarget target;
  ChartSource source;
  DomainLocator on_target, on_source;

  SearchableChart(const CompatibleMesh& mesh, const RefinedSource& refined, const Chart& chart)
      : target(mesh.target, mesh.target_labels, chart),
        source(lay_out(refined, facets_of(chart, refined.labels), target)),
        on_target(target.piece(), target.directions(), Vec3::Zero()),
        on_source(source.piece, source.directions, Vec3::Zero()) {}
};

/// A vertex of the refined source as barycentric coordinates of a facet of the source it lies in.
Vec3 within(const Facet& facet, int vertex, int originals, const std::vector<EdgePoint>& points) {
  const auto unit = [&](int v) {
    Vec3 result = Vec3::Zero();
    for (int i = 0; i < 3; ++i) result[i] = facet[i] == v ? 1 : 0;
    return result;
  };
  if (vertex < originals) return unit(vertex);
  const EdgePoint& place = points[vertex - originals];
  return (1 - place.fraction) * unit(place.a) + place.fraction * unit(place.b);
}

}  // namespace

struct TwoWayMap::Sides {
  const CompatibleMesh& mesh;
  std::optional<RefinedSource> refined = std::nullopt;
  std::vector<std::unique_ptr<SearchableChart>> charts = {};
  std::vector<int> chart_of_part = {};
  std::vector<std::vector<int>> pieces = {};  // per source facet: its facets in the refined source
  std::unique_ptr<SurfaceIndex> target_index = nullptr, compatible_index = nullptr;

  /// The point as one of the refined source: of all pieces of its facet, the one it lies in most.
  SurfacePoint on_refined(const SurfacePoint& point) const {
    const Facet& facet = mesh.source.facet(point.facet);
    SurfacePoint best;
    double least = 0;
    for (const int piece : pieces[point.facet]) {
      Eigen::Matrix3d corners;
      for (int i = 0; i < 3; ++i) {
        corners.col(i) = within(facet, refined->split.mesh.facet(piece)[i], mesh.source.vertex_count(),
                                refined->split.points);
      }
      const Vec3 coordinates = corners.inverse() * point.barycentric;
      if (best.facet >= 0 && !(coordinates.minCoeff() > least)) continue;
      least = coordinates.minCoeff();
      best = {piece, coordinates.cwiseMax(0) / coordinates.cwiseMax(0).sum()};
    }
    return best;
  }
};

TwoWayMap::TwoWayMap(const CompatibleMesh& mesh) : sides_(std::make_unique<Sides>(Sides{mesh})) {
  if (mesh.charts.empty()) {
    sides_->target_index = std::make_unique<SurfaceIndex>(mesh.target);
    sides_->compatible_index = std::make_unique<SurfaceIndex>(mesh.points, mesh.source.facets());
    return;
  }
  sides_->refined = refine_source(mesh);
  sides_->chart_of_part.assign(mesh.part_names.size(), -1);
  for (const Chart& chart : mesh.charts) {
    for (const int part : chart.parts) {
      sides_->chart_of_part[part] = static_cast<int>(sides_->charts.size());
    }
    sides_->charts.push_back(std::make_unique<SearchableChart>(mesh, *sides_->refined, chart));
  }
  sides_->pieces.resize(mesh.source.facet_count());
  const std::vector<int>& parents = sides_->refined->split.parent_facet;
  for (std::size_t f = 0; f < parents.size(); ++f) sides_->pieces[parents[f]].push_back(static_cast<int>(f));
}

TwoWayMap::~TwoWayMap() = default;
TwoWayMap::TwoWayMap(TwoWayMap&&) noexcept = default;
TwoWayMap& TwoWayMap::operator=(TwoWayMap&&) noexcept = default;

bool TwoWayMap::one_to_one() const {
  return !sides_->charts.empty();
}

SurfacePoint TwoWayMap::to_target(const SurfacePoint& on_source) const {
  const Sides& sides = *sides_;
  const CompatibleMesh& mesh = sides.mesh;
  if (!one_to_one()) {
    const Facet& f = mesh.source.facet(on_source.facet);
    Vec3 place = Vec3::Zero();
    for (int i = 0; i < 3; ++i) place += on_source.barycentric[i] * mesh.points[f[i]];
    return sides.target_index->closest(place).point;
  }
  const SearchableChart& chart = *sides.charts[sides.chart_of_part[mesh.source_labels[on_source.facet]]];
  const SurfacePoint refined = sides.on_refined(on_source);
  const Facet& f = sides.refined->split.mesh.facet(refined.facet);
  Vec3 direction = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    direction += refined.barycentric[i] * chart.source.directions[chart.source.piece.local_vertex(f[i])];
  }
  return chart.on_target.on_model(chart.on_target.locate(direction).front());
}

SurfacePoint TwoWayMap::to_source(const SurfacePoint& on_target) const {
  const Sides& sides = *sides_;
  const CompatibleMesh& mesh = sides.mesh;
  if (!one_to_one()) return sides.compatible_index->closest(position(mesh.target, on_target)).point;
  const SearchableChart& chart = *sides.charts[sides.chart_of_part[mesh.target_labels[on_target.facet]]];
  const Facet& f = mesh.target.facet(on_target.facet);
  Vec3 direction = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    direction +=
        on_target.barycentric[i] * chart.target.directions()[chart.target.piece().local_vertex(f[i])];
  }
  const SurfacePoint found = chart.on_source.on_model(chart.on_source.locate(direction).front());
  return sides.refined->split.on_original(mesh.source, found);
}

SurfacePoint TwoWayMap::vertex_to_target(int source_vertex) const {
  return sides_->mesh.map[source_vertex];
}

SurfacePoint TwoWayMap::vertex_to_source(int target_vertex) const {
  const CompatibleMesh& mesh = sides_->mesh;
  if (!mesh.inverse.empty()) return mesh.inverse[target_vertex];
  return sides_->compatible_index->closest(mesh.target.point(target_vertex)).point;
}

}  // namespace partwise
