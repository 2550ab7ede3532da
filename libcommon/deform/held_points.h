#pragma once

#include <vector>

#include "deform/surface_integration.h"
#include "mesh/surface_point.h"

namespace partwise {

/// Points of a mesh that stand where they are told to, while the surface between them keeps its shape as well
/// as it can: the correction of least bending, whose Laplacian is least (biharmonic), so that no spike is
/// pulled at a point. A single point per component just moves the component.
///
/// The correction is linear: what it takes beyond the factorisation is prepared once for all poses.
class HeldPoints {
 public:
  /// \param integration of `mesh`; must outlive this
  /// \throws InputError when two points are the same place
  HeldPoints(const TriMesh& mesh, const SurfaceIntegration& integration, std::vector<SurfacePoint> points);

  /// `positions` of the mesh's vertices, corrected so that each point is at its entry of `places`. Components
  /// without a point stay.
  Points corrected(Points positions, const Points& places) const;

 private:
  Facets facets_;
  std::vector<SurfacePoint> points_;
  std::vector<int> components_;  // per vertex
  Eigen::MatrixXd fields_;  // per vertex and point: what a pull there does, up to a constant per component
  std::vector<int> held_;   // components that have points, ascending
  Eigen::FullPivLU<Eigen::MatrixXd> system_;  // for the pulls and the moves of the components held
};

}  // namespace partwise
