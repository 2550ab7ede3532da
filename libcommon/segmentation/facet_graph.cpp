#include "segmentation/facet_graph.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <utility>

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
  tbb::parallel_for(0, static_cast<int>(result.size()), [&](int e) {
    const HalfedgeHandle h = half_edges.halfedge_handle(EdgeHandle(e), 0);
    const OpenMesh::FaceHandle a = half_edges.face_handle(h), b = half_edges.opposite_face_handle(h);
    if (!a.is_valid() || !b.is_valid()) return;
    const Vec3& from = mesh.point(half_edges.from_vertex_handle(h).idx());
    const Vec3& to = mesh.point(half_edges.to_vertex_handle(h).idx());
    const Vec3 middle = (from + to) / 2;
    const double way = (centroid(mesh, a.idx()) - middle).norm() + (middle - centroid(mesh, b.idx())).norm();
    // Slivers and facets without area would give weights that no double-precision system carries.
    const double ratio = std::clamp((to - from).norm() / std::max(way, 1e-300), 1e-4, 1e4);
    result[e] = ratio * std::exp(-3 * std::min(concavity[e] / 20, 4.0));
  });
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
  FacetLinks links;
  std::vector<double> by_edge, sizes;
  tbb::parallel_invoke([&] { links = facet_links(mesh); }, [&] { by_edge = conductances(mesh, concavity); },
                       [&] {
                         sizes = facet_areas(mesh.points(), mesh.facets());
                         const double h = mean_edge_length(mesh);
                         for (double& size : sizes) size = std::sqrt(size) / h;
                       });
  std::vector<double> conductance(links.edge.size()), cut_cost(links.edge.size());
  tbb::parallel_for(std::size_t{0}, links.edge.size(), [&](std::size_t k) {
    conductance[k] = by_edge[links.edge[k]];
    cut_cost[k] = boundary_costs[links.edge[k]];
  });
  return {std::move(links.first), std::move(links.neighbour), std::move(conductance), std::move(cut_cost),
          std::move(sizes)};
}

}  // namespace partwise
