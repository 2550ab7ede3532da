#include "mesh/canonical_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace partwise {
namespace {

using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

/// Mean of the facets' centroids, weighted by area: it does not depend on how vertices are spread.
Vec3 area_centroid(const TriMesh& mesh) {
  Vec3 moment = Vec3::Zero(), origin = mesh.facet_count() > 0 ? mesh.point(mesh.facet(0)[0]) : Vec3::Zero();
  double total = 0;
  for (const auto& [a, b, c] : mesh.facets()) {
    const Vec3 p = mesh.point(a) - origin, q = mesh.point(b) - origin, r = mesh.point(c) - origin;
    const double area = (q - p).cross(r - p).norm();
    moment += area * (p + q + r) / 3;
    total += area;
  }
  return total > 0 ? Vec3(origin + moment / total) : origin;
}

/// A facet as a place to start from: its corner to start at, and how far out it is. The weights differ, so
/// that a facet and its mirror image, whose corners turn the other way, have different values.
struct Start {
  double distance = 0;
  int facet = 0;
  int corner = 0;
};

std::vector<Start> starts(const TriMesh& mesh) {
  const Vec3 centre = area_centroid(mesh);
  std::vector<double> distances;
  for (const Vec3& point : mesh.points()) distances.push_back((point - centre).norm());
  std::vector<Start> result;
  for (int f = 0; f < mesh.facet_count(); ++f) {
    Start best{-1, f, 0};
    for (int i = 0; i < 3; ++i) {
      const Facet& facet = mesh.facet(f);
      const double value =
          4 * distances[facet[i]] + 2 * distances[facet[(i + 1) % 3]] + distances[facet[(i + 2) % 3]];
      if (value > best.distance) best = {value, f, i};
    }
    result.push_back(best);
  }
  return result;
}

}  // namespace

CanonicalOrder canonical_order(const TriMesh& mesh) {
  const HalfEdges& half_edges = mesh.half_edges();
  std::vector<Start> order = starts(mesh);
  auto farther = [](const Start& a, const Start& b) {
    return std::pair(-a.distance, a.facet) < std::pair(-b.distance, b.facet);
  };
  std::make_heap(order.begin(), order.end(), [&](const Start& a, const Start& b) { return farther(b, a); });

  std::vector<int> vertices, place(mesh.vertex_count(), -1);
  std::vector<bool> visited(mesh.facet_count(), false);
  Facets facets;
  std::vector<HalfedgeHandle> reached;  // one per facet visited
  auto number = [&](VertexHandle v) {
    if (place[v.idx()] < 0) {
      place[v.idx()] = static_cast<int>(vertices.size());
      vertices.push_back(v.idx());
    }
    return place[v.idx()];
  };
  auto visit = [&](HalfedgeHandle h) {
    const auto f = half_edges.face_handle(h);
    if (!f.is_valid() || visited[f.idx()]) return;
    visited[f.idx()] = true;
    reached.push_back(h);
    Facet facet;
    for (int& corner : facet) {
      corner = number(half_edges.from_vertex_handle(h));
      h = half_edges.next_halfedge_handle(h);
    }
    facets.push_back(facet);
  };
  // One round per component: a heap, since most meshes have one.
  while (!order.empty() && reached.size() < visited.size()) {
    std::pop_heap(order.begin(), order.end(), [&](const Start& a, const Start& b) { return farther(b, a); });
    const Start start = order.back();
    order.pop_back();
    if (visited[start.facet]) continue;
    const Facet& facet = mesh.facet(start.facet);
    std::size_t next = reached.size();
    visit(half_edges.find_halfedge(VertexHandle(facet[start.corner]),
                                   VertexHandle(facet[(start.corner + 1) % 3])));
    for (; next < reached.size(); ++next) {
      HalfedgeHandle h = reached[next];
      for (int side = 0; side < 3; ++side, h = half_edges.next_halfedge_handle(h)) {
        visit(half_edges.opposite_halfedge_handle(h));
      }
    }
  }
  for (int v = 0; v < mesh.vertex_count(); ++v) number(VertexHandle(v));  // those without a facet

  Points points;
  for (const int v : vertices) points.push_back(mesh.point(v));
  return {std::move(vertices), TriMesh(std::move(points), std::move(facets))};
}

}  // namespace partwise
