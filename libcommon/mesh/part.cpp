#include "mesh/part.h"

#include <algorithm>
#include <utility>

#include "mesh/submesh.h"

namespace partwise {
namespace {

using OpenMesh::HalfedgeHandle;

/// Boundary loops of an open mesh, each walked with the mesh on its left, starting at its smallest vertex.
std::vector<std::vector<int>> boundary_loops(const TriMesh& mesh) {
  const HalfEdges& half_edges = mesh.half_edges();
  std::vector<std::vector<int>> loops;
  std::vector<bool> visited(mesh.vertex_count(), false);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (visited[v] || !half_edges.is_boundary(OpenMesh::VertexHandle(v))) continue;
    // OpenMesh keeps the boundary half-edge as a boundary vertex's outgoing one; it has the mesh on its
    // right.
    const HalfedgeHandle start = half_edges.halfedge_handle(OpenMesh::VertexHandle(v));
    std::vector<int> loop;
    HalfedgeHandle h = start;
    do {
      const int from = half_edges.from_vertex_handle(h).idx();
      visited[from] = true;
      loop.push_back(from);
      h = half_edges.prev_halfedge_handle(h);
    } while (h != start);
    loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace

Part extract_piece(const TriMesh& mesh, const std::vector<bool>& inside) {
  Submesh open = extract_submesh(mesh, inside);
  Points points = open.mesh.points();
  Facets facets = open.mesh.facets();
  std::vector<std::vector<int>> loops = boundary_loops(open.mesh);
  std::vector<int> cap_vertices;
  for (const std::vector<int>& loop : loops) {
    const int centre = static_cast<int>(points.size());
    Vec3 centroid = Vec3::Zero();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      centroid += points[loop[i]] / static_cast<double>(loop.size());
      facets.push_back({loop[(i + 1) % loop.size()], loop[i], centre});
      open.model_facet.push_back(-1);
    }
    points.push_back(centroid);
    open.model_vertex.push_back(-1);
    cap_vertices.push_back(centre);
  }
  return {-1,
          TriMesh(std::move(points), std::move(facets)),
          std::move(open.model_vertex),
          std::move(open.model_facet),
          std::move(loops),
          std::move(cap_vertices)};
}

Part extract_part(const SegmentedModel& model, int part) {
  Part result = extract_piece(model.mesh, facets_labelled(model.segmentation.labels, part));
  result.index = part;
  return result;
}

int Part::local_vertex(int of_model) const {
  const auto end = model_vertex.end() - static_cast<std::ptrdiff_t>(cap_vertices.size());
  const auto found = std::lower_bound(model_vertex.begin(), end, of_model);
  return found != end && *found == of_model ? static_cast<int>(found - model_vertex.begin()) : -1;
}

bool Part::is_sphere() const {
  const auto edges = static_cast<int>(mesh.half_edges().n_edges());
  if (mesh.vertex_count() - edges + mesh.facet_count() != 2) return false;
  std::vector<bool> seen(mesh.vertex_count(), false);
  std::vector<int> reached{0};
  seen[0] = true;
  for (std::size_t next = 0; next < reached.size(); ++next) {
    for (const auto w : mesh.half_edges().vv_range(OpenMesh::VertexHandle(reached[next]))) {
      if (seen[w.idx()]) continue;
      seen[w.idx()] = true;
      reached.push_back(w.idx());
    }
  }
  return static_cast<int>(reached.size()) == mesh.vertex_count();
}

}  // namespace partwise
