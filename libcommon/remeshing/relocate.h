#pragma once

#include "geometry/mean_value_weights.h"
#include "remeshing/coverage_fit.h"
#include "remeshing/critical_fit.h"
#include "remeshing/gap_closing.h"
#include "remeshing/one_to_one_map.h"
#include "remeshing/refine.h"
#include "remeshing/registration.h"
#include "remeshing/relax_on_surface.h"
#include "remeshing/umbrella.h"
#include "remeshing/unfold.h"

namespace partwise {

enum class RelocateMethod {
  relax,    ///< within the one-to-one map, see relocate
  umbrella  ///< the paper's own scheme, for comparison; may fold
};

struct RelocateOptions {
  RelocateMethod method = RelocateMethod::relax;
  int rounds = 4;             ///< of vertex relocation, Eq. (18); >= 0
  double lambda = 0.5;        ///< share of the way to the weighted mean of the neighbours, in (0, 1]
  double convergence = 1e-4;  ///< rounds end when the mean move falls below this, over the diagonal
  LaplacianKind umbrella_weights = LaplacianKind::mean_value;  ///< of method umbrella; uniform for comparison
  int relax_sweeps = 10;                                       ///< of distortion, after the rounds; >= 0
  SurfaceRelaxationOptions relaxation = {};
  RegistrationOptions registration = {};
  CriticalFitOptions critical = {};
  GapClosingOptions gaps = {};
  CoverageFitOptions fit = {};
  UnfoldOptions unfold = {};
  int mend_sweeps = 10;       ///< of mend_faults at the end; >= 0
  RefineOptions refine = {};  ///< by default nothing is added
};

struct RelocateMetrics {
  int critical_points = 0;   ///< of the target
  int critical_reached = 0;  ///< those at which a vertex was brought
  int rounds = 0;            ///< of relocation
  int fit_moves = 0;
  int flipped_before = 0, flipped_after = 0;
  double rms_distance_before = 0, rms_distance_after = 0;  ///< target's vertices to the mesh, over l
  double max_distance_before = 0, max_distance_after = 0;
  RefineFigures refine;              ///< all 0 when nothing was asked for
  std::vector<ChartFigures> charts;  ///< of the result; empty when the mesh came without charts. Of method
                                     ///< umbrella they may say that the map is not one-to-one any more
};

struct Relocation {
  CompatibleMesh mesh;
  RelocateMetrics metrics;
};

/// Moves the vertices of a compatible mesh over the target, so that it takes the target's features and its
/// facets the source's shape ([Wu11] 6.1.2, 6.2): relaxation of the whole map (relax_on_surface), first alone
/// and then drawn to a registration of the source (relax_towards_registration), critical points (Eq. (17)),
/// vertex relocation by the source's mean-value weights (Eq. (18)), then again relaxation of the map's
/// distortion (towards the source's facets, scaled as their part is), closing of the gaps that are left
/// between the surfaces (close_gaps), unfolding of what is flipped, a fit of what is missed, and mending
/// of facets that run into others (mend_faults).
///
/// Every vertex stays exactly on the target and the map is kept. Markers (at source vertices) and the
/// boundary of an open source stay in place, critical points that were reached until gaps are closed. No step
/// adds a flipped facet, and a map that is one-to-one stays so; its inverse is made anew.
///
/// Differs from [Wu11]: a vertex walks over the target instead of leaving it and being projected back, so
/// that it never lands on another sheet that is near in space; its step is lambda times the way to the
/// weighted mean, as the distance to the target by which the paper divides is 0. Method umbrella is the
/// paper's scheme (relocate_by_umbrella) with its options rounds, lambda, convergence and critical; a mesh
/// that is not one-to-one afterwards has no charts. Both are followed by `refine`. \throws InputError when
/// options are out of range
Relocation relocate(const CompatibleMesh& mesh, const RelocateOptions& options = {});

/// One round of Eq. (18), vertex by vertex; returns the mean length of the moves, in units of the model.
double relocation_round(MeshOnSurface& mesh, const VertexWeights& weights, double lambda);

}  // namespace partwise
