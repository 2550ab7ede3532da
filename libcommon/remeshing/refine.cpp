#include "remeshing/refine.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "error.h"
#include "remeshing/coverage_gaps.h"
#include "remeshing/intersection_guard.h"
#include "remeshing/one_to_one_map.h"
#include "remeshing/split_source.h"
#include "remeshing/unfold.h"

namespace partwise {
namespace {

constexpr double kShareOfWorst = 0.5;  // gaps narrower than this share of the widest wait for the next round
constexpr int kMostRoundsInVain = 6;   // without a narrower widest gap

/// Chooses edges to cut, at most one per facet.
class EdgeChoice {
 public:
  explicit EdgeChoice(const CompatibleMesh& mesh)
      : mesh_(mesh), splittable_(splittable_edges(mesh)), is_cut_(mesh.source.facet_count(), false) {}

  /// Cuts the facet at `place`, unless it is cut already, across the edge that is longest and nearest.
  std::optional<EdgePoint> cut_at(const SurfacePoint& place) {
    if (is_cut_[place.facet]) return std::nullopt;
    const Facet& f = mesh_.source.facet(place.facet);
    double best = 0;
    int across = -1;
    EdgePoint point;
    for (int i = 0; i < 3; ++i) {
      const int a = f[i], b = f[(i + 1) % 3];
      const double share_of_third = place.barycentric[(i + 2) % 3];
      const double score = (1 - share_of_third) * (mesh_.points[b] - mesh_.points[a]).norm();
      const int beside = facet_across(a, b);
      if (score <= best || beside < 0) continue;
      best = score;
      across = beside;
      const double share = share_of_third < 1 ? place.barycentric[(i + 1) % 3] / (1 - share_of_third) : 0.5;
      point = {a, b, std::clamp(share, 0.25, 0.75)};
    }
    if (across < 0) return std::nullopt;
    is_cut_[place.facet] = is_cut_[across] = true;
    return point;
  }

 private:
  /// -1 when the edge cannot be cut.
  int facet_across(int a, int b) const {
    const HalfEdges& half_edges = mesh_.source.half_edges();
    const auto h = half_edges.find_halfedge(OpenMesh::VertexHandle(a), OpenMesh::VertexHandle(b));
    if (!splittable_[half_edges.edge_handle(h).idx()]) return -1;
    const int facet = half_edges.opposite_face_handle(h).idx();
    return is_cut_[facet] ? -1 : facet;
  }

  const CompatibleMesh& mesh_;
  std::vector<bool> splittable_;
  std::vector<bool> is_cut_;
};

/// Flipped facets among some, and pairs of intersecting facets.
int faults_of(const MeshOnSurface& mesh, const IntersectionGuard& guard, const std::vector<int>& facets) {
  int faults = guard.count_of(facets);
  for (const int f : facets) faults += mesh.quality(f) < 0;
  return faults;
}

std::vector<int> facets_beside(const TriMesh& mesh, const EdgePoint& place) {
  const HalfEdges& half_edges = mesh.half_edges();
  const auto h = half_edges.find_halfedge(OpenMesh::VertexHandle(place.a), OpenMesh::VertexHandle(place.b));
  std::vector<int> facets{half_edges.face_handle(h).idx(), half_edges.opposite_face_handle(h).idx()};
  std::sort(facets.begin(), facets.end());
  return facets;
}

/// Cuts edges, and looks for places of the new vertices where no further facet is flipped or intersects.
class Cut {
 public:
  /// \param goals per place: where on the target the mesh should come near
  Cut(const CompatibleMesh& mesh, const std::vector<EdgePoint>& places,
      const std::vector<SurfacePoint>& goals)
      : originals_(mesh.source.vertex_count()),
        places_(places),
        mesh_(split_source(mesh, places)),
        moving_(mesh_),
        guard_(moving_) {
    const MeshOnSurface before(mesh);
    const IntersectionGuard guard_before(before);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const int faults = faults_of(before, guard_before, facets_beside(mesh.source, places[i]));
      settle(i, faults, position(mesh.target, goals[i]));
    }
  }

  MeshOnSurface& moving() { return moving_; }

  /// The mesh with all vertices where they have come to.
  CompatibleMesh finish() const { return with_images(mesh_, moving_.images()); }

 private:
  int faults_at(int vertex) const {
    const auto ring = moving_.ring(vertex);
    return faults_of(moving_, guard_, {ring.begin(), ring.end()});
  }

  /// Tries the goal, the place in the edge, where nothing has changed, and half way to each.
  void settle(std::size_t i, int faults_before, const Vec3& goal) {
    const int vertex = originals_ + static_cast<int>(i);
    int least = faults_at(vertex);
    const auto& [a, b, fraction] = places_[i];
    const Vec3 from = moving_.points()[vertex];
    const Vec3 in_edge = (1 - fraction) * moving_.points()[a] + fraction * moving_.points()[b];
    const SurfacePoint start = moving_.image(vertex);
    SurfacePoint best = start;
    for (const Vec3& wanted : {goal, Vec3((from + goal) / 2), in_edge, Vec3((from + in_edge) / 2)}) {
      if (least <= faults_before) break;
      const SurfacePoint there = moving_.walker().towards(start, wanted);
      if (!moving_.allows(vertex, there)) continue;
      moving_.place(vertex, there);
      const int faults = faults_at(vertex);
      if (faults >= least) continue;
      least = faults;
      best = there;
    }
    moving_.place(vertex, best);
    guard_.moved(vertex);
  }

  int originals_;
  const std::vector<EdgePoint>& places_;
  CompatibleMesh mesh_;
  MeshOnSurface moving_;
  IntersectionGuard guard_;
};

/// The edges to cut in one round.
struct Round {
  std::vector<EdgePoint> places;
  std::vector<SurfacePoint> goals;
};

Round choose(const CompatibleMesh& mesh, const std::vector<CoverageGap>& gaps, int most) {
  EdgeChoice choice(mesh);
  Round round;
  for (const CoverageGap& gap : gaps) {
    if (gap.distance < kShareOfWorst * gaps.front().distance) break;
    if (static_cast<int>(round.places.size()) == most) break;
    const std::optional<EdgePoint> place = choice.cut_at(gap.place);
    if (!place) continue;
    round.places.push_back(*place);
    round.goals.push_back(gap.goal);
  }
  return round;
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
  const CoverageGaps search(mesh.target);
  RefineFigures& figures = result.figures;
  std::vector<CoverageGap> gaps = search.wider_than(least, mesh);
  figures.gaps_before = static_cast<int>(gaps.size());
  double narrowest = std::numeric_limits<double>::infinity();  // of the widest gaps of all rounds
  int in_vain = 0;
  while (!gaps.empty() && in_vain < kMostRoundsInVain) {
    const Round round = choose(result.mesh, gaps, allowed - figures.added_vertices);
    if (round.places.empty()) break;
    ++figures.rounds;
    figures.added_vertices += static_cast<int>(round.places.size());
    in_vain = gaps.front().distance < narrowest ? 0 : in_vain + 1;
    narrowest = std::min(narrowest, gaps.front().distance);
    Cut cut(result.mesh, round.places, round.goals);
    fit_coverage(cut.moving(), options.fit);
    unfold(cut.moving(), options.unfold);
    result.mesh = cut.finish();
    gaps = search.wider_than(least, result.mesh);
  }
  figures.gaps_after = static_cast<int>(gaps.size());
  if (figures.rounds > 0 && !result.mesh.charts.empty()) result.mesh.inverse = inverse_map(result.mesh);
  return result;
}

}  // namespace partwise
