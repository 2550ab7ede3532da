#include "remeshing/map_guard.h"

#include "geometry/orientation.h"

namespace partwise {

MapGuard::MapGuard(const CompatibleMesh& mesh) {
  if (mesh.charts.empty()) return;
  homes_.resize(mesh.source.vertex_count());
  const RefinedSource source = refine_source(mesh);
  for (const Chart& chart : mesh.charts) {
    ChartTarget target(mesh.target, mesh.target_labels, chart);
    ChartSource side = lay_out(source, facets_of(chart, source.labels), target);
    const Part& piece = side.piece;
    std::vector<bool> on_loop(piece.mesh.vertex_count(), false);
    for (const std::vector<int>& loop : piece.loops) {
      for (const int v : loop) on_loop[v] = true;
    }
    for (int local = 0; local < piece.mesh.vertex_count(); ++local) {
      const int v = piece.model_vertex[local];
      if (v < 0 || v >= mesh.source.vertex_count() || on_loop[local]) continue;
      homes_[v] = {static_cast<int>(charts_.size()), local};
    }
    charts_.push_back({std::move(target), std::move(side)});
  }
}

bool MapGuard::allows(int source_vertex, const SurfacePoint& image) const {
  if (!has_charts()) return true;
  const Home& home = homes_[source_vertex];
  if (home.chart < 0) return false;
  const auto& [target, source] = charts_[home.chart];
  if (!target.is_inside(image.facet)) return false;
  const std::optional<Vec3> direction = target.direction(image);
  if (!direction) return false;
  const TriMesh& mesh = source.piece.mesh;
  for (const auto f : mesh.half_edges().vf_range(OpenMesh::VertexHandle(home.local))) {
    const Facet& facet = mesh.facet(f.idx());
    auto corner = [&](int i) -> const Vec3& {
      return facet[i] == home.local ? *direction : source.directions[facet[i]];
    };
    if (orientation_sign(Vec3::Zero(), corner(0), corner(1), corner(2)) <= 0) return false;
  }
  return true;
}

void MapGuard::place(int source_vertex, const SurfacePoint& image) {
  if (!has_charts() || homes_[source_vertex].chart < 0) return;
  auto& [target, source] = charts_[homes_[source_vertex].chart];
  if (const auto direction = target.direction(image))
    source.directions[homes_[source_vertex].local] = *direction;
}

}  // namespace partwise
