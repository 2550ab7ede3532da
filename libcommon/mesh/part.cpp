#include "mesh/part.h"

#include <utility>

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

Part extract_part(const SegmentedModel& model, int part) {
  const TriMesh& mesh = model.mesh;
  std::vector<int> local(mesh.vertex_count(), -1);
  std::vector<int> model_vertex, model_facet;
  for (int f = 0; f < mesh.facet_count(); ++f) {
    if (model.segmentation.labels[f] != part) continue;
    model_facet.push_back(f);
    for (const int v : mesh.facet(f)) local[v] = 0;
  }
  Points points;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (local[v] < 0) continue;
    local[v] = static_cast<int>(points.size());
    model_vertex.push_back(v);
    points.push_back(mesh.point(v));
  }
  Facets facets;
  for (const int f : model_facet) {
    const Facet& facet = mesh.facet(f);
    facets.push_back({local[facet[0]], local[facet[1]], local[facet[2]]});
  }

  std::vector<std::vector<int>> loops = boundary_loops(TriMesh(points, facets));
  std::vector<int> cap_vertices;
  for (const std::vector<int>& loop : loops) {
    const int centre = static_cast<int>(points.size());
    Vec3 centroid = Vec3::Zero();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      centroid += points[loop[i]] / static_cast<double>(loop.size());
      facets.push_back({loop[(i + 1) % loop.size()], loop[i], centre});
      model_facet.push_back(-1);
    }
    points.push_back(centroid);
    model_vertex.push_back(-1);
    cap_vertices.push_back(centre);
  }
  return {part,
          TriMesh(std::move(points), std::move(facets)),
          std::move(model_vertex),
          std::move(model_facet),
          std::move(loops),
          std::move(cap_vertices)};
}

}  // namespace partwise
