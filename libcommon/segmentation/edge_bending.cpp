#include "segmentation/edge_bending.h"

#include <cmath>

namespace partwise {

using OpenMesh::EdgeHandle;
using OpenMesh::HalfedgeHandle;

EdgeEnds edge_ends(const TriMesh& mesh, int edge) {
  const HalfedgeHandle h = mesh.half_edges().halfedge_handle(EdgeHandle(edge), 0);
  return {mesh.half_edges().from_vertex_handle(h).idx(), mesh.half_edges().to_vertex_handle(h).idx()};
}

double dihedral_angle(const TriMesh& mesh, const Points& normals, int edge) {
  const HalfEdges& half_edges = mesh.half_edges();
  const HalfedgeHandle h = half_edges.halfedge_handle(EdgeHandle(edge), 0);
  const auto left = half_edges.face_handle(h);
  const auto right = half_edges.face_handle(half_edges.opposite_halfedge_handle(h));
  if (!left.is_valid() || !right.is_valid()) return 0;
  const auto [from, to] = edge_ends(mesh, edge);
  const Vec3 direction = (mesh.point(to) - mesh.point(from)).stableNormalized();
  const Vec3& n = normals[left.idx()];
  const Vec3& m = normals[right.idx()];
  return std::atan2(n.cross(m).dot(direction), n.dot(m));
}

}  // namespace partwise
