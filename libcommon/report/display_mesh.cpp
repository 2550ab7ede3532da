#include "report/display_mesh.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include <numeric>

#include "mesh/segmentation.h"

namespace partwise::report {

namespace {

struct Traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
  VertexAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal);
  EdgeAttributes(OpenMesh::Attributes::Status);
};
using CollapsibleMesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

CollapsibleMesh collapsible(const TriMesh& mesh) {
  CollapsibleMesh result;
  for (const Vec3& p : mesh.points()) {
    result.add_vertex({p[0], p[1], p[2]});
  }
  const auto vertex = [](int index) { return OpenMesh::VertexHandle(index); };
  for (const Facet& f : mesh.facets()) {
    result.add_face(vertex(f[0]), vertex(f[1]), vertex(f[2]));
  }
  result.update_face_normals();
  return result;
}

// Vertices of edges that have one facet, or facets of two parts.
void lock_boundaries(CollapsibleMesh& mesh, const std::vector<int>& labels) {
  for (const auto edge : mesh.edges()) {
    const auto a = edge.h0().face();
    const auto b = edge.h1().face();
    if (a.is_valid() && b.is_valid() && labels[a.idx()] == labels[b.idx()]) continue;
    mesh.status(edge.v0()).set_locked(true);
    mesh.status(edge.v1()).set_locked(true);
  }
}

void decimate(CollapsibleMesh& mesh, int most) {
  OpenMesh::Decimater::DecimaterT<CollapsibleMesh> decimater(mesh);
  OpenMesh::Decimater::ModQuadricT<CollapsibleMesh>::Handle quadric;
  OpenMesh::Decimater::ModNormalFlippingT<CollapsibleMesh>::Handle flipping;
  decimater.add(quadric);
  decimater.add(flipping);
  decimater.module(quadric).unset_max_err();
  decimater.initialize();
  decimater.decimate_to_faces(0, static_cast<std::size_t>(most));
}

DisplayMesh whole(const TriMesh& mesh) {
  DisplayMesh result{std::vector<int>(mesh.vertex_count()), mesh.facets(),
                     std::vector<int>(mesh.facet_count())};
  std::iota(result.vertices.begin(), result.vertices.end(), 0);
  std::iota(result.origin.begin(), result.origin.end(), 0);
  return result;
}

}  // namespace

DisplayMesh display_mesh(const TriMesh& mesh, const std::vector<int>& labels, int most) {
  if (mesh.facet_count() <= most) return whole(mesh);
  CollapsibleMesh shown = collapsible(mesh);
  lock_boundaries(shown, labels);
  decimate(shown, most);
  DisplayMesh result;
  std::vector<int> number(mesh.vertex_count(), -1);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (shown.status(OpenMesh::VertexHandle(v)).deleted()) continue;
    number[v] = static_cast<int>(result.vertices.size());
    result.vertices.push_back(v);
  }
  for (int f = 0; f < mesh.facet_count(); ++f) {
    const OpenMesh::SmartFaceHandle face(f, &shown);
    if (shown.status(face).deleted()) continue;
    Facet corners{};
    int i = 0;
    for (const auto vertex : face.vertices()) {
      corners[i++] = number[vertex.idx()];
    }
    result.facets.push_back(corners);
    result.origin.push_back(f);
  }
  return result;
}

}  // namespace partwise::report
