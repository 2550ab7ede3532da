#include "mapping/ring_mesh.h"

#include <algorithm>

namespace partwise {
namespace {

using Ring = RingMesh::Ring;

Ring::iterator position_of(Ring& ring, int vertex) {
  return std::find(ring.begin(), ring.end(), vertex);
}

/// Turns the cyclic list so that it starts at `vertex`.
void start_at(Ring& ring, int vertex) {
  std::rotate(ring.begin(), position_of(ring, vertex), ring.end());
}

}  // namespace

RingMesh::RingMesh(const TriMesh& mesh) : rings_(mesh.vertex_count()), present_count_(mesh.vertex_count()) {
  const HalfEdges& half_edges = mesh.half_edges();
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    for (const auto neighbour : half_edges.vv_ccw_range(OpenMesh::VertexHandle(v))) {
      rings_[v].push_back(neighbour.idx());
    }
  }
}

bool RingMesh::can_collapse(int u, int v) const {
  if (present_count_ <= 4) return false;
  int common = 0;
  for (const int neighbour : rings_[u]) {
    if (std::find(rings_[v].begin(), rings_[v].end(), neighbour) != rings_[v].end()) ++common;
  }
  return common == 2;
}

Ring RingMesh::collapse(int u, int v) {
  Ring ring = std::move(rings_[u]);
  rings_[u].clear();
  --present_count_;
  start_at(ring, v);
  const std::size_t degree = ring.size();
  // ring = v, a, r2 ... r(d-2), b: a and b lose u, the others get v instead, v gets the others instead of u.
  for (const int side : {ring[1], ring[degree - 1]}) rings_[side].erase(position_of(rings_[side], u));
  for (std::size_t i = 2; i + 1 < degree; ++i) *position_of(rings_[ring[i]], u) = v;
  Ring& star = rings_[v];
  const auto at = star.erase(position_of(star, u));
  star.insert(at, ring.begin() + 2, ring.end() - 1);
  return ring;
}

void RingMesh::restore(int u, const Ring& ring) {
  const std::size_t degree = ring.size();
  const int v = ring[0], a = ring[1], b = ring[degree - 1];
  rings_[a].insert(position_of(rings_[a], v), u);
  rings_[b].insert(position_of(rings_[b], v) + 1, u);
  for (std::size_t i = 2; i + 1 < degree; ++i) *position_of(rings_[ring[i]], v) = u;
  Ring& star = rings_[v];
  start_at(star, a);
  star.erase(star.begin() + 1, star.begin() + 1 + static_cast<std::ptrdiff_t>(degree - 3));
  star.insert(star.begin() + 1, u);
  rings_[u] = ring;
  ++present_count_;
}

}  // namespace partwise
