#include "segmentation/screen_stroke.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>
#include <unordered_map>
#include <utility>

#include "segmentation/surface_places.h"

namespace partwise {
namespace {

using OpenMesh::VertexHandle;
using Pixel = Eigen::Vector2d;

constexpr double kCoarsest = 1.0;     // pixels between samples
constexpr double kFinest = 1.0 / 16;  // where neighbouring samples hit distant facets
constexpr double kLongest = 100'000;  // pixels of a segment that are sampled a pixel apart

class Projector {
 public:
  Projector(const TriMesh& mesh, const SurfaceIndex& index, const Camera& camera)
      : mesh_(mesh),
        index_(index),
        camera_(camera),
        from_clip_((camera.projection * camera.view).inverse()) {}

  /// Vertex under a pixel, if any.
  std::optional<int> vertex_at(const Pixel& pixel) const {
    const double x = 2 * pixel.x() / camera_.width - 1;
    const double y = 1 - 2 * pixel.y() / camera_.height;
    const Vec3 near = unprojected(x, y, -1);
    const auto hit = index_.first_hit(near, unprojected(x, y, 1) - near);
    if (!hit) return std::nullopt;
    return nearest_corner(mesh_, hit->point);
  }

  /// Adds what lies between two samples, denser while they hit vertices that no edge joins.
  void refine(const Pixel& a, std::optional<int> at_a, const Pixel& b, std::optional<int> at_b,
              std::vector<int>& vertices) const {
    if ((b - a).norm() < kFinest || are_close(at_a, at_b)) return;
    const Pixel middle = (a + b) / 2;
    const std::optional<int> here = vertex_at(middle);
    refine(a, at_a, middle, here, vertices);
    if (here) vertices.push_back(*here);
    refine(middle, here, b, at_b, vertices);
  }

 private:
  Vec3 unprojected(double x, double y, double z) const {
    return (from_clip_ * Eigen::Vector4d(x, y, z, 1)).hnormalized();
  }
  bool are_close(std::optional<int> a, std::optional<int> b) const {
    if (!a || !b) return a == b;
    return *a == *b || mesh_.half_edges().find_halfedge(VertexHandle(*a), VertexHandle(*b)).is_valid();
  }

  const TriMesh& mesh_;
  const SurfaceIndex& index_;
  const Camera& camera_;
  Eigen::Matrix4d from_clip_;
};

/// Vertices under a polyline's samples, in order.
std::vector<int> sampled_vertices(const Projector& projector, const std::vector<Pixel>& polyline) {
  std::vector<int> vertices;
  Pixel last = polyline.front();
  std::optional<int> at_last = projector.vertex_at(last);
  if (at_last) vertices.push_back(*at_last);
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    const Pixel start = polyline[i - 1], way = polyline[i] - start;
    const int steps = static_cast<int>(std::ceil(std::clamp(way.norm() / kCoarsest, 1.0, kLongest)));
    for (int step = 1; step <= steps; ++step) {
      const Pixel pixel = start + way * step / steps;
      const std::optional<int> here = projector.vertex_at(pixel);
      projector.refine(last, at_last, pixel, here, vertices);
      if (here) vertices.push_back(*here);
      last = pixel;
      at_last = here;
    }
  }
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

}  // namespace

std::vector<int> shortest_edge_path(const TriMesh& mesh, int from, int to) {
  std::unordered_map<int, std::pair<double, int>> reached;  // distance, previous vertex
  using Front = std::pair<double, int>;
  std::priority_queue<Front, std::vector<Front>, std::greater<>> queue;
  reached[from] = {0, -1};
  queue.emplace(0, from);
  while (!queue.empty() && queue.top().second != to) {
    const auto [distance, v] = queue.top();
    queue.pop();
    if (distance > reached.at(v).first) continue;
    for (const VertexHandle w : mesh.half_edges().vv_range(VertexHandle(v))) {
      const double length = distance + (mesh.point(w.idx()) - mesh.point(v)).norm();
      const auto [entry, is_new] = reached.try_emplace(w.idx(), length, v);
      if (!is_new && entry->second.first <= length) continue;
      entry->second = {length, v};
      queue.emplace(length, w.idx());
    }
  }
  std::vector<int> path;
  if (queue.empty()) return path;
  for (int v = to; v >= 0; v = reached.at(v).second) path.push_back(v);
  std::reverse(path.begin(), path.end());
  return path;
}

std::vector<int> project_stroke(const TriMesh& mesh, const SurfaceIndex& index, const ScreenStroke& stroke) {
  const Projector projector(mesh, index, stroke.camera);
  const std::vector<int> sampled = sampled_vertices(projector, stroke.polyline);
  std::vector<int> vertices;
  for (const int v : sampled) {
    if (!vertices.empty()) {
      const std::vector<int> bridge = shortest_edge_path(mesh, vertices.back(), v);
      if (bridge.size() > 2) vertices.insert(vertices.end(), bridge.begin() + 1, bridge.end() - 1);
    }
    vertices.push_back(v);
  }
  return vertices;
}

}  // namespace partwise
