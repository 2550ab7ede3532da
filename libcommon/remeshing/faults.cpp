#include "remeshing/faults.h"

#include "measure/self_intersections.h"

namespace partwise {
namespace {

/// Corners of flipped and of intersecting facets, ascending.
std::vector<int> faulty_corners(const MeshOnSurface& mesh) {
  const Facets& facets = mesh.source().facets();
  std::vector<bool> is_faulty(mesh.points().size(), false);
  const auto note = [&](int facet) {
    for (const int v : facets[facet]) is_faulty[v] = true;
  };
  for (int f = 0; f < mesh.source().facet_count(); ++f) {
    if (mesh.quality(f) < 0) note(f);
  }
  for (const auto& [f, g] : self_intersections(mesh.points(), facets)) {
    note(f);
    note(g);
  }
  std::vector<int> corners;
  for (std::size_t v = 0; v < is_faulty.size(); ++v) {
    if (is_faulty[v] && !mesh.is_pinned(static_cast<int>(v))) corners.push_back(static_cast<int>(v));
  }
  return corners;
}

/// Where a vertex might lie better.
Points alternatives(const MeshOnSurface& mesh, int vertex) {
  const Vec3& from = mesh.points()[vertex];
  Points neighbours;
  Vec3 mean = Vec3::Zero();
  for (const auto w : mesh.source().half_edges().vv_range(OpenMesh::VertexHandle(vertex))) {
    neighbours.push_back(mesh.points()[w.idx()]);
    mean += neighbours.back();
  }
  mean /= static_cast<double>(neighbours.size());
  Points result{mean, (from + mean) / 2};
  for (const Vec3& neighbour : neighbours) {
    result.emplace_back((3 * from + neighbour) / 4);
    result.emplace_back((from + neighbour) / 2);
  }
  return result;
}

/// \return whether the vertex moved
bool mend(MeshOnSurface& mesh, FaultCounter& faults, int vertex) {
  int least = faults.around(vertex);
  if (least == 0) return false;
  const int flipped = mesh.flipped_around(vertex);
  const SurfacePoint start = mesh.image(vertex);
  SurfacePoint best = start;
  bool has_moved = false;
  for (const Vec3& goal : alternatives(mesh, vertex)) {
    const SurfacePoint there = mesh.walker().towards(start, goal);
    if (!mesh.allows(vertex, there)) continue;
    mesh.place(vertex, there);
    const int now = faults.around(vertex);
    if (now >= least || mesh.flipped_around(vertex) > flipped) continue;
    least = now;
    best = there;
    has_moved = true;
  }
  mesh.place(vertex, best);
  faults.moved(vertex);
  return has_moved;
}

}  // namespace

int FaultCounter::around(int vertex) const {
  const auto ring = mesh_.ring(vertex);
  return of({ring.begin(), ring.end()});
}

int FaultCounter::of(const std::vector<int>& facets) const {
  int count = guard_.count_of(facets);
  for (const int f : facets) count += mesh_.quality(f) < 0;
  return count;
}

int mend_faults(MeshOnSurface& mesh, int sweeps) {
  FaultCounter faults(mesh);
  int moves = 0;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    int now = 0;
    for (const int vertex : faulty_corners(mesh)) now += mend(mesh, faults, vertex);
    moves += now;
    if (now == 0) break;
  }
  return moves;
}

}  // namespace partwise
