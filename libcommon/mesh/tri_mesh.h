#pragma once

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>

#include <cstdint>
#include <memory>

#include "mesh/types.h"

namespace partwise {

/// Half-edges of a mesh; handle indices equal the 0-based vertex and facet indices of the mesh.
using HalfEdges = OpenMesh::TriConnectivity;

/// Identifies a connectivity: equal for equal facet lists over the same number of vertices.
enum class MeshKey : std::uint64_t {};

/// Immutable oriented 2-manifold triangle mesh; boundary, any genus and several components are allowed.
///
/// Copies share the connectivity. Vertex and facet indices are those of the input, for good.
class TriMesh {
 public:
  /// \throws InputError naming the first defects (see find_defects) when the facets are no oriented
  /// 2-manifold.
  TriMesh(Points points, Facets facets);

  int vertex_count() const { return static_cast<int>(points_.size()); }
  int facet_count() const { return static_cast<int>(connectivity_->facets.size()); }

  const Points& points() const { return points_; }
  const Facets& facets() const { return connectivity_->facets; }
  const Vec3& point(int vertex) const { return points_[vertex]; }
  const Facet& facet(int index) const { return connectivity_->facets[index]; }
  const HalfEdges& half_edges() const { return connectivity_->half_edges; }
  MeshKey key() const { return connectivity_->key; }

  /// V - E + F: 2 for a sphere, 2 less for every handle.
  int euler_characteristic() const {
    return vertex_count() - static_cast<int>(half_edges().n_edges()) + facet_count();
  }

  /// Length of the bounding box's diagonal, the l that every tolerance and distance is relative to.
  double diagonal() const;

  /// The same connectivity over other positions. \pre points.size() == vertex_count()
  TriMesh with_points(Points points) const;

 private:
  struct Connectivity {
    Facets facets;
    HalfEdges half_edges;
    MeshKey key;
  };
  TriMesh(Points points, std::shared_ptr<const Connectivity> connectivity);

  Points points_;
  std::shared_ptr<const Connectivity> connectivity_;
};

/// Length of the diagonal of the bounding box of `points`; 0 for none.
double bounding_box_diagonal(const Points& points);

}  // namespace partwise
