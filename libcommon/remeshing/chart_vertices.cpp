#include "remeshing/chart_vertices.h"

#include <array>
#include <cmath>
#include <set>

namespace partwise {
namespace {

using Edge = std::array<int, 2>;

Edge sorted(int a, int b) {
  return a < b ? Edge{a, b} : Edge{b, a};
}

/// Adds the target's vertices that lie between the images of neighbours on a loop.
class LoopVertices {
 public:
  explicit LoopVertices(CompatibleMesh& mesh) : mesh_(mesh), unrefined_(refine_source(mesh)) {}

  void add(const Chart& chart, const ChartTarget& target) {
    const ChartSource side = lay_out(unrefined_, facets_of(chart, mesh_.source_labels), target);
    for (std::size_t i = 0; i < side.piece.loops.size(); ++i) {
      const std::vector<double> steps = loop_steps(side, unrefined_.images, i, target);
      const std::vector<int>& loop = side.piece.loops[i];
      for (std::size_t j = 0; j < loop.size(); ++j) {
        const int a = side.piece.model_vertex[loop[j]];
        const int b = side.piece.model_vertex[loop[(j + 1) % loop.size()]];
        if (done_.insert(sorted(a, b)).second) add_between(a, b, steps[j], target);
      }
    }
  }

 private:
  /// Shares of arc length are measured along the target.
  void add_between(int a, int b, double step, const ChartTarget& target) {
    const ChartTarget::LoopPlace from = *target.on_loop(unrefined_.images[a]);
    const std::vector<int>& loop = target.piece().loops[from.loop];
    const Points& points = target.piece().mesh.points();
    const Vec3 end = position(mesh_.target, unrefined_.images[b]);
    Vec3 last = position(mesh_.target, unrefined_.images[a]);
    double length = 0;
    std::vector<std::array<double, 2>> between;  // number along the loop, length from a
    for (double k = std::floor(from.position) + 1; k < from.position + step; ++k) {
      const Vec3& here = points[loop[static_cast<std::size_t>(k) % loop.size()]];
      length += (here - last).norm();
      between.push_back({k, length});
      last = here;
    }
    length += (end - last).norm();
    for (const auto& [k, reached] : between) {
      const double share = reached / length;
      if (!(share > 0 && share < 1)) continue;  // an edge without length; the chart's check will say so
      const int local = loop[static_cast<std::size_t>(k) % loop.size()];
      mesh_.added_vertices.push_back({{a, b, share}, at_vertex(target.piece(), local)});
    }
  }

  SurfacePoint at_vertex(const Part& piece, int local) const {
    for (const auto f : piece.mesh.half_edges().vf_range(OpenMesh::VertexHandle(local))) {
      if (piece.is_cap_facet(f.idx())) continue;
      SurfacePoint point{piece.model_facet[f.idx()], Vec3::Zero()};
      for (int i = 0; i < 3; ++i) point.barycentric[i] = piece.mesh.facet(f.idx())[i] == local ? 1 : 0;
      return point;
    }
    return {};
  }

  CompatibleMesh& mesh_;
  RefinedSource unrefined_;
  std::set<Edge> done_;
};

/// Halves the edges inside a piece of the source that join two vertices of its boundary.
void add_chords(CompatibleMesh& mesh, const Chart& chart) {
  const Part piece = extract_piece(mesh.source, facets_of(chart, mesh.source_labels));
  const HalfEdges& half_edges = piece.mesh.half_edges();
  std::vector<bool> on_loop(piece.mesh.vertex_count(), false);
  for (const std::vector<int>& loop : piece.loops) {
    for (const int v : loop) on_loop[v] = true;
  }
  for (const auto e : half_edges.edges()) {
    const auto h = half_edges.halfedge_handle(e, 0);
    const int a = half_edges.from_vertex_handle(h).idx(), b = half_edges.to_vertex_handle(h).idx();
    const bool at_cap = piece.is_cap_facet(half_edges.face_handle(h).idx()) ||
                        piece.is_cap_facet(half_edges.opposite_face_handle(h).idx());
    if (!on_loop[a] || !on_loop[b] || at_cap) continue;
    mesh.added_vertices.push_back({{piece.model_vertex[a], piece.model_vertex[b], 0.5}, {}});
  }
}

}  // namespace

void add_chart_vertices(CompatibleMesh& mesh, const std::vector<ChartTarget>& targets) {
  LoopVertices loops(mesh);
  for (std::size_t k = 0; k < targets.size(); ++k) loops.add(mesh.charts[k], targets[k]);
  for (const Chart& chart : mesh.charts) add_chords(mesh, chart);
}

}  // namespace partwise
