#include "segmentation/suggest_sketch.h"

#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <utility>

#include "error.h"
#include "segmentation/edge_distances.h"
#include "segmentation/seeds.h"

namespace partwise {
namespace {

constexpr int kSpread = 32;         // vertices that stand for the whole shape when the core is sought
constexpr double kTipShare = 0.4;   // of the way from a tip to the core, the tip's stroke
constexpr double kCoreShare = 0.3;  // of the ways from the core, the core's stroke

/// `count` vertices, each the farthest from `start` and those before it.
std::vector<int> far_vertices(const TriMesh& mesh, int start, int count) {
  std::vector<int> found;
  std::vector<int> starts{start};
  for (int i = 0; i < count; ++i) {
    const int next = edge_distances(mesh, starts, {}).farthest();
    found.push_back(next);
    starts.push_back(next);
  }
  return found;
}

/// Per vertex the sum of squared distances to vertices spread over the shape: small in its middle, with local
/// maxima at the ends of what sticks out.
std::vector<double> remoteness(const TriMesh& mesh) {
  const int end = edge_distances(mesh, {0}, {}).farthest();
  std::vector<double> sum(mesh.vertex_count());
  for (const int v : far_vertices(mesh, end, std::min(kSpread, mesh.vertex_count() / 2))) {
    const EdgeDistances ways = edge_distances(mesh, {v}, {});
    for (std::size_t w = 0; w < sum.size(); ++w) sum[w] += ways.distance[w] * ways.distance[w];
  }
  return sum;
}

std::vector<int> local_maxima(const TriMesh& mesh, const std::vector<double>& field) {
  std::vector<int> maxima;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const auto ring = mesh.half_edges().vv_range(OpenMesh::VertexHandle(v));
    if (std::none_of(ring.begin(), ring.end(),
                     [&](OpenMesh::VertexHandle w) { return field[w.idx()] > field[v]; })) {
      maxima.push_back(v);
    }
  }
  return maxima;
}

/// `count` ends of the shape, each the farthest from the core and the ends before it; where nothing sticks
/// out any more, any vertex.
std::vector<int> tips_of(const TriMesh& mesh, int core, const std::vector<double>& field, int count) {
  const std::vector<int> ends = local_maxima(mesh, field);
  std::vector<int> tips, starts{core};
  for (int i = 0; i < count; ++i) {
    const EdgeDistances ways = edge_distances(mesh, starts, {});
    const auto farther = [&](int a, int b) { return ways.distance[a] < ways.distance[b]; };
    const auto end = std::max_element(ends.begin(), ends.end(), farther);
    const bool sticks_out = end != ends.end() && ways.distance[*end] > 0;
    tips.push_back(sticks_out ? *end : ways.farthest());
    starts.push_back(tips.back());
  }
  return tips;
}

void require_one_component(const TriMesh& mesh) {
  const std::vector<int> component = facet_components(mesh);
  if (*std::max_element(component.begin(), component.end()) == 0) return;
  throw InputError(
      "the mesh has several components: parts can be suggested for one only; keep the largest "
      "(convert-mesh --keep-largest-component), or draw strokes");
}

}  // namespace

Sketch suggest_sketch(const TriMesh& mesh, int part_count) {
  require_one_component(mesh);
  const std::vector<double> field = remoteness(mesh);
  const auto core = static_cast<int>(std::min_element(field.begin(), field.end()) - field.begin());
  const EdgeDistances ways = edge_distances(mesh, {core}, {});
  const std::vector<int> tips = tips_of(mesh, core, field, part_count - 1);
  Sketch sketch;
  sketch.mesh = SketchedMesh{mesh.vertex_count(), mesh.facet_count()};
  std::set<int> core_stroke{core};
  for (std::size_t i = 0; i < tips.size(); ++i) {
    const double length = ways.distance[tips[i]];
    VertexStroke stroke;
    for (const int v : ways.way_back(tips[i])) {
      if (ways.distance[v] >= (1 - kTipShare) * length) stroke.vertices.push_back(v);
      if (ways.distance[v] <= kCoreShare * length) core_stroke.insert(v);
    }
    sketch.parts.push_back({"part " + std::to_string(i + 1), {std::move(stroke)}});
  }
  sketch.parts.insert(sketch.parts.begin(),
                      {"core", {VertexStroke{{core_stroke.begin(), core_stroke.end()}}}});
  return sketch;
}

}  // namespace partwise
