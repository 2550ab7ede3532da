#include "segmentation/facet_graph.h"

#include <algorithm>
#include <cmath>

#include "geometry/normals.h"
#include "segmentation/crease_field.h"

namespace partwise {
namespace {

using OpenMesh::EdgeHandle;
using OpenMesh::HalfedgeHandle;

Vec3 centroid(const TriMesh& mesh, int f) {
  const auto& [a, b, c] = mesh.facet(f);
  return (mesh.point(a) + mesh.point(b) + mesh.point(c)) / 3;
}

/// Per edge; 0 at the boundary of the mesh.
std::vector<double> conductances(const TriMesh& mesh, const std::vector<double>& concavity) {
  const HalfEdges& half_edges = mesh.half_edges();
  std::vector<double> result(half_edges.n_edges(), 0.0);
  for (std::size_t e = 0; e < result.size(); ++e) {
    const HalfedgeHandle h = half_edges.halfedge_handle(EdgeHandle(static_cast<int>(e)), 0);
    const OpenMesh::FaceHandle a = half_edges.face_handle(h), b = half_edges.opposite_face_handle(h);
    if (!a.is_valid() || !b.is_valid()) continue;
    const Vec3& from = mesh.point(half_edges.from_vertex_handle(h).idx());
    const Vec3& to = mesh.point(half_edges.to_vertex_handle(h).idx());
    const Vec3 middle = (from + to) / 2;
    const double way = (centroid(mesh, a.idx()) - middle).norm() + (middle - centroid(mesh, b.idx())).norm();
    // Slivers and facets without area would give weights that no double-precision system carries.
    const double ratio = std::clamp((to - from).norm() / std::max(way, 1e-300), 1e-4, 1e4);
    result[e] = ratio * std::exp(-3 * std::min(concavity[e] / 20, 4.0));
  }
  return result;
}

}  // namespace

FacetLinks facet_links(const TriMesh& mesh) {
  const HalfEdges& half_edges = mesh.half_edges();
  FacetLinks links;
  links.first.reserve(mesh.facet_count() + 1);
  links.neighbour.reserve(3 * mesh.facet_count());
  links.edge.reserve(3 * mesh.facet_count());
  for (int f = 0; f < mesh.facet_count(); ++f) {
    HalfedgeHandle h = half_edges.halfedge_handle(OpenMesh::FaceHandle(f));
    for (int side = 0; side < 3; ++side, h = half_edges.next_halfedge_handle(h)) {
      const auto across = half_edges.opposite_face_handle(h);
      if (!across.is_valid()) continue;
      links.neighbour.push_back(across.idx());
      links.edge.push_back(half_edges.edge_handle(h).idx());
    }
    links.first.push_back(static_cast<int>(links.neighbour.size()));
  }
  return links;
}

FacetGraph facet_graph(const TriMesh& mesh, const std::vector<double>& concavity,
                       const std::vector<double>& boundary_costs) {
  FacetLinks links = facet_links(mesh);
  FacetGraph graph{std::move(links.first), std::move(links.neighbour), {}, {}, {}};
  const std::vector<double> by_edge = conductances(mesh, concavity);
  graph.conductance.reserve(links.edge.size());
  graph.cut_cost.reserve(links.edge.size());
  for (const int e : links.edge) {
    graph.conductance.push_back(by_edge[e]);
    graph.cut_cost.push_back(boundary_costs[e]);
  }
  graph.size = facet_areas(mesh.points(), mesh.facets());
  const double h = mean_edge_length(mesh);
  for (double& size : graph.size) size = std::sqrt(size) / h;
  return graph;
}

}  // namespace partwise
