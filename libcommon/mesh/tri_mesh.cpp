#include "mesh/tri_mesh.h"

#include <string>
#include <utility>

#include "error.h"
#include "mesh/validation.h"

namespace partwise {
namespace {

MeshKey fingerprint(std::size_t vertex_count, const Facets& facets) {
  // FNV-1a over whole words: fast, and stable across machines and runs.
  std::uint64_t hash = 14695981039346656037ULL ^ vertex_count;
  for (const Facet& facet : facets) {
    for (const int vertex : facet) {
      hash = (hash ^ static_cast<std::uint64_t>(vertex)) * 1099511628211ULL;
    }
  }
  return static_cast<MeshKey>(hash);
}

HalfEdges half_edges_of(int vertex_count, const Facets& facets) {
  HalfEdges half_edges;
  half_edges.reserve(vertex_count, facets.size() * 3 / 2 + 16, facets.size());
  for (int v = 0; v < vertex_count; ++v) half_edges.add_vertex();
  for (const Facet& f : facets) {
    half_edges.add_face(OpenMesh::VertexHandle(f[0]), OpenMesh::VertexHandle(f[1]),
                        OpenMesh::VertexHandle(f[2]));
  }
  return half_edges;
}

std::string joined(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences) {
    if (!text.empty()) text += "; ";
    text += sentence;
  }
  return text;
}

}  // namespace

TriMesh::TriMesh(Points points, Facets facets) : points_(std::move(points)) {
  const std::vector<std::string> defects = find_defects(points_, facets);
  if (!defects.empty()) throw InputError(joined(defects));
  HalfEdges half_edges = half_edges_of(vertex_count(), facets);
  const MeshKey key = fingerprint(points_.size(), facets);
  connectivity_ =
      std::make_shared<const Connectivity>(Connectivity{std::move(facets), std::move(half_edges), key});
}

TriMesh::TriMesh(Points points, std::shared_ptr<const Connectivity> connectivity)
    : points_(std::move(points)), connectivity_(std::move(connectivity)) {}

double TriMesh::diagonal() const {
  return bounding_box_diagonal(points_);
}

TriMesh TriMesh::with_points(Points points) const {
  if (points.size() != points_.size()) {
    throw InputError("expected " + std::to_string(points_.size()) + " positions, got " +
                     std::to_string(points.size()));
  }
  return TriMesh(std::move(points), connectivity_);
}

double bounding_box_diagonal(const Points& points) {
  Eigen::AlignedBox3d box;
  for (const Vec3& point : points) box.extend(point);
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

}  // namespace partwise
