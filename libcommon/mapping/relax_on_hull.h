#pragma once

#include <vector>

#include "mapping/star_hull.h"
#include "mesh/tri_mesh.h"

namespace partwise {

/// Where a vertex should be: a position on the hull, relative to its centre.
struct Pin {
  int vertex = 0;
  Vec3 goal = Vec3::Zero();
};

struct HullRelaxationOptions {
  /// Of the hull's edges (the spacing of SmoothHull), in the order of the relaxations: coarse to fine finds
  /// lower minima in fewer iterations.
  std::vector<double> rounding{0.2, 0.05};
  int most_iterations = 60;      ///< of each relaxation
  double least_decrease = 1e-3;  ///< relative; two iterations in a row below it end a relaxation
  std::vector<Pin> pulls;        ///< vertices drawn towards their goals, by pull_weight |p - goal|^2 each
  double pull_weight = 0;        ///< against area (|J|^2 + |J^-1|^2), no unit
};

struct HullRelaxation {
  Points images;  ///< per vertex, on the hull, relative to its centre
  /// Symmetric Dirichlet, weighted mean of (|J|^2 + |J^-1|^2) / 4 over the flat triangles between images: 1
  /// for an isometry.
  double distortion = 0;
  int iterations = 0;
};

/// The distortion of a map as HullRelaxation has it; infinite when a facet of `images` is not positively
/// oriented. \param images per vertex, on the hull, relative to its centre
double hull_distortion(const TriMesh& mesh, const std::vector<double>& vertex_weights, const StarHull& hull,
                       const Points& images);

/// Lowers the distortion of a one-to-one map of a closed mesh onto a hull by Newton's method on the symmetric
/// Dirichlet energy (Smith and Schaefer 2015), along the hull with its edges rounded off, where the energy is
/// smooth; no step turns a facet over.
///
/// `start` are directions or positions relative to the hull's centre. The mesh is scaled to the hull's area.
/// \pre every facet of `start` is positively oriented seen from the centre; `vertex_weights` as for
///      embed_progressively; `fixed` is empty or has one entry per vertex, fixed vertices stay where they
///      start
HullRelaxation relax_on_hull(const TriMesh& mesh, const std::vector<double>& vertex_weights,
                             const StarHull& hull, const Points& start, const std::vector<bool>& fixed,
                             const HullRelaxationOptions& options);

}  // namespace partwise
