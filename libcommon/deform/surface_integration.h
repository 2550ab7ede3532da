#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "mesh/tri_mesh.h"

namespace partwise {

/// The edges that a facet should have: entry i leads from corner i to corner (i + 1) % 3.
using FacetEdges = std::array<Vec3, 3>;

/// The edges that a facet has.
FacetEdges facet_edges(const Points& points, const Facet& facet);

/// Finds the positions whose edges are nearest to those that every facet asks for by itself.
///
/// Minimises the sum over facets and their edges of w |v_j - v_i - d|^2 with cotangent weights w of the
/// reference shapes, kept positive. That is the Poisson equation of gradient-domain deformation (Yu et al.
/// 2004; Botsch et al. 2006 show that deformation transfer is the same): where the edges asked for fit
/// together, they are met exactly, whatever the weights. One factorisation serves any number of frames.
class SurfaceIntegration {
 public:
  /// \param shapes one or more positions of the mesh's vertices; the weights are the mean over them
  SurfaceIntegration(const TriMesh& mesh, const std::vector<Points>& shapes);
  ~SurfaceIntegration();
  SurfaceIntegration(SurfaceIntegration&&) noexcept;
  SurfaceIntegration& operator=(SurfaceIntegration&&) noexcept;

  /// Connected components of the mesh, and per vertex the component it belongs to.
  int component_count() const;
  const std::vector<int>& components() const;

  /// Per component: mean of its vertices.
  Points centres(const Points& points) const;

  /// Fields, one per column, that the Laplacian takes to `right`: per vertex the weighted sum of differences
  /// from its neighbours. The first vertex of each component is 0, and its row of `right` is not asked for.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;

  /// Positions for each frame.
  /// \param edges (frame, facet) -> the edges asked for; called for several frames at a time
  /// \param centres per frame and component: where the mean of its vertices should be
  std::vector<Points> integrate(const std::function<FacetEdges(int frame, int facet)>& edges,
                                const std::vector<Points>& centres) const;

 private:
  struct System;
  std::unique_ptr<System> system_;
};

}  // namespace partwise
