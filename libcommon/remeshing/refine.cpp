#include "remeshing/refine.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "error.h"
#include "mesh/vertex_rings.h"
#include "remeshing/coverage_gaps.h"
#include "remeshing/faults.h"
#include "remeshing/one_to_one_map.h"
#include "remeshing/part_scales.h"
#include "remeshing/refinement_cuts.h"

namespace partwise {
namespace {

constexpr int kMostRoundsInVain = 20;  // without a narrower widest gap
constexpr int kMovingRings = 2;        // around new vertices

std::vector<int> facets_beside(const TriMesh& mesh, const EdgePoint& place) {
  const HalfEdges& half_edges = mesh.half_edges();
  const auto h = half_edges.find_halfedge(OpenMesh::VertexHandle(place.a), OpenMesh::VertexHandle(place.b));
  std::vector<int> facets{half_edges.face_handle(h).idx(), half_edges.opposite_face_handle(h).idx()};
  std::sort(facets.begin(), facets.end());
  return facets;
}

/// Looks for places of new vertices where no further facet is flipped or intersects.
class Settling {
 public:
  /// \param mesh before edges were cut
  /// \param moving after that
  Settling(const CompatibleMesh& mesh, const RefinementCuts& cuts, MeshOnSurface& moving)
      : originals_(mesh.source.vertex_count()), cuts_(cuts), moving_(moving), faults_(moving) {
    const MeshOnSurface before(mesh);
    const FaultCounter faults_before(before);
    for (const EdgePoint& place : cuts.places) {
      faults_before_.push_back(faults_before.of(facets_beside(mesh.source, place)));
    }
  }

  void settle() {
    for (std::size_t i = 0; i < cuts_.places.size(); ++i) settle(i);
  }

 private:
  /// Tries the goal, the place in the edge, where nothing has changed, and half way to each.
  void settle(std::size_t i) {
    const int vertex = originals_ + static_cast<int>(i);
    int least = faults_.around(vertex);
    const auto& [a, b, fraction] = cuts_.places[i];
    const Vec3 goal = position(moving_.target(), cuts_.goals[i]);
    const Vec3 from = moving_.points()[vertex];
    const Vec3 in_edge = (1 - fraction) * moving_.points()[a] + fraction * moving_.points()[b];
    const SurfacePoint start = moving_.image(vertex);
    SurfacePoint best = start;
    for (const Vec3& wanted : {goal, Vec3((from + goal) / 2), in_edge, Vec3((from + in_edge) / 2)}) {
      if (least <= faults_before_[i]) break;
      const SurfacePoint there = moving_.walker().towards(start, wanted);
      if (!moving_.allows(vertex, there)) continue;
      moving_.place(vertex, there);
      const int faults = faults_.around(vertex);
      if (faults >= least) continue;
      least = faults;
      best = there;
    }
    moving_.place(vertex, best);
    faults_.moved(vertex);
  }

  int originals_;
  const RefinementCuts& cuts_;
  MeshOnSurface& moving_;
  FaultCounter faults_;
  std::vector<int> faults_before_;  // per place
};

/// Pins all vertices that are not near new ones, from `first_new` on, so that what fits stays.
/// \return those that were not pinned
std::vector<int> pin_far(MeshOnSurface& mesh, int first_new) {
  std::vector<bool> near(mesh.points().size(), false);
  std::fill(near.begin() + first_new, near.end(), true);
  near = within_rings(mesh.source().facets(), std::move(near), kMovingRings);
  std::vector<int> pinned;
  for (int v = 0; v < first_new; ++v) {
    if (near[v] || mesh.is_pinned(v)) continue;
    mesh.pin(v);
    pinned.push_back(v);
  }
  return pinned;
}

void check(const RefineOptions& options) {
  if (!(options.error >= 0)) throw InputError("the error to refine to must not be negative");
  if (!(options.limit >= 0)) throw InputError("the limit of added vertices must not be negative");
}

}  // namespace

Refined refine(const CompatibleMesh& mesh, const RefineOptions& options) {
  check(options);
  Refined result{mesh, {}};
  if (options.error == 0) return result;
  const double least = options.error * mesh.target.diagonal();
  const int allowed = static_cast<int>(options.limit * mesh.source.vertex_count());
  const CoverageGaps search(mesh.target, as_measured());
  RefineFigures& figures = result.figures;
  std::vector<CoverageGap> gaps = search.wider_than(least, mesh);
  figures.gaps_before = static_cast<int>(gaps.size());
  double narrowest = std::numeric_limits<double>::infinity();  // of the widest gaps of all rounds
  int in_vain = 0;
  EdgeSet uncuttable;
  GapClosingOptions closing = options.gaps;
  closing.threshold = std::min(closing.threshold, options.error / 2);
  while (!gaps.empty() && in_vain < kMostRoundsInVain) {
    RefinementCuts cuts = choose_cuts(result.mesh, gaps, allowed - figures.added_vertices, uncuttable);
    if (cuts.places.empty()) break;
    const CompatibleMesh cut = split_source_one_to_one(result.mesh, cuts, uncuttable);
    if (cuts.places.empty()) continue;  // with other edges
    ++figures.rounds;
    figures.added_vertices += static_cast<int>(cuts.places.size());
    in_vain = gaps.front().distance < narrowest ? 0 : in_vain + 1;
    narrowest = std::min(narrowest, gaps.front().distance);
    MeshOnSurface moving(cut);
    Settling(result.mesh, cuts, moving).settle();
    const std::vector<int> held = pin_far(moving, result.mesh.source.vertex_count());
    close_gaps(moving, cut, part_scales(cut), {}, closing);
    for (const int v : held) moving.unpin(v);
    fit_coverage(moving, options.fit);
    unfold(moving, options.unfold);
    mend_faults(moving, options.mend_sweeps);
    result.mesh = with_images(cut, moving.images());
    gaps = search.wider_than(least, result.mesh);
  }
  figures.gaps_after = static_cast<int>(gaps.size());
  if (figures.rounds > 0 && !result.mesh.charts.empty()) result.mesh.inverse = inverse_map(result.mesh);
  return result;
}

}  // namespace partwise
