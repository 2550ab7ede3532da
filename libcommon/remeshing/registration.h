#pragma once

#include "energy/energy_term.h"
#include "geometry/relief.h"
#include "remeshing/mesh_on_surface.h"

namespace partwise {

struct RegistrationOptions {
  int steps = 4;                ///< of matching and deforming, from stiff to soft; 0: no registration
  double stiffest = 1e3;        ///< weight of the deformation against the matches, at the first step
  double softest = 0.5;         ///< and at the last; > 0
  double reach = 0.03;          ///< matches are this near to a vertex's image, over the diagonal; > 0
  double normal_weight = 0.1;   ///< of a difference of unit normals, over the diagonal
  double relief_weight = 0.25;  ///< of a difference in relief, over the diagonal
  std::vector<double> pulls{1, 0.3, 0.1};  ///< strengths, one after the other, with which the map is drawn
  int iterations = 4;                      ///< of Newton's method per strength
};

/// Deforms the source smoothly towards the target, by what the surfaces look like: a non-rigid registration,
/// started from the images that the mesh's vertices have.
///
/// Every vertex is matched with the place of the target (vertices and centres of facets) within `reach` of
/// its image that is nearest in place, normal and relief together; the source takes the shape of least
/// affine_deformation_term and squared distances to the matches, weighted by how well normals agree; and
/// again with less stiffness. Pinned vertices stay at their images.
///
/// \return per vertex where it comes to (not on the target, and not one-to-one: a guide, not a map), and as
/// weight the agreement of the last match, 0 to 1
std::vector<VertexTarget> register_source(const MeshOnSurface& mesh, const RegistrationOptions& options = {});

/// Draws the map towards the registration while it relaxes (relax_on_surface), firmly at first and then less.
/// \param scales see relax_on_surface
void relax_towards_registration(MeshOnSurface& mesh, const std::vector<double>& scales,
                                const RegistrationOptions& options = {});

}  // namespace partwise
