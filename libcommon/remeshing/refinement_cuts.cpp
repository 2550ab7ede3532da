#include "remeshing/refinement_cuts.h"

#include <optional>

#include "remeshing/map_guard.h"
#include "remeshing/split_source.h"

namespace partwise {
namespace {

constexpr double kShareOfWorst = 0.5;  // gaps narrower than this share of the widest wait
constexpr double kFarLonger = 1.5;     // times as long: an edge that is cut first

class EdgeChoice {
 public:
  EdgeChoice(const CompatibleMesh& mesh, const EdgeSet& uncuttable)
      : mesh_(mesh),
        uncuttable_(uncuttable),
        splittable_(splittable_edges(mesh)),
        is_cut_(mesh.source.facet_count(), false) {}

  /// Nothing when the facet is cut already, or one on the way to the edge that should be.
  std::optional<EdgePoint> cut_at(int facet) {
    if (is_cut_[facet]) return std::nullopt;
    Candidate chosen;
    while (true) {
      const Candidate next = longest_edge(facet);
      if (next.length <= kFarLonger * chosen.length) break;
      if (is_cut_[next.across]) return std::nullopt;
      chosen = next;
      facet = next.across;
    }
    if (chosen.facet < 0) return std::nullopt;
    is_cut_[chosen.facet] = is_cut_[chosen.across] = true;
    return EdgePoint{chosen.a, chosen.b, 0.5};
  }

 private:
  struct Candidate {
    double length = 0;
    int a = -1, b = -1;
    int facet = -1, across = -1;
  };

  /// Among the edges that can be cut; of length 0 when there is none.
  Candidate longest_edge(int facet) const {
    const HalfEdges& half_edges = mesh_.source.half_edges();
    Candidate longest;
    for (int i = 0; i < 3; ++i) {
      const Facet& f = mesh_.source.facet(facet);
      const int a = f[i], b = f[(i + 1) % 3];
      const double length = (mesh_.points[b] - mesh_.points[a]).norm();
      const auto h = half_edges.find_halfedge(OpenMesh::VertexHandle(a), OpenMesh::VertexHandle(b));
      const bool can_be_cut =
          splittable_[half_edges.edge_handle(h).idx()] && !uncuttable_.contains(std::minmax(a, b));
      if (can_be_cut && length > longest.length)
        longest = {length, a, b, facet, half_edges.opposite_face_handle(h).idx()};
    }
    return longest;
  }

  const CompatibleMesh& mesh_;
  const EdgeSet& uncuttable_;
  std::vector<bool> splittable_;
  std::vector<bool> is_cut_;
};

}  // namespace

RefinementCuts choose_cuts(const CompatibleMesh& mesh, const std::vector<CoverageGap>& gaps, int most,
                           const EdgeSet& uncuttable) {
  EdgeChoice choice(mesh, uncuttable);
  RefinementCuts cuts;
  for (const CoverageGap& gap : gaps) {
    if (gap.distance < kShareOfWorst * gaps.front().distance) break;
    if (static_cast<int>(cuts.places.size()) == most) break;
    const std::optional<EdgePoint> place = choice.cut_at(gap.place.facet);
    if (!place) continue;
    cuts.places.push_back(*place);
    cuts.goals.push_back(gap.goal);
  }
  return cuts;
}

CompatibleMesh split_source_one_to_one(const CompatibleMesh& mesh, RefinementCuts& cuts,
                                       EdgeSet& uncuttable) {
  while (true) {
    CompatibleMesh result = split_source(mesh, cuts.places);
    const MapGuard guard(result);
    RefinementCuts kept;
    for (std::size_t i = 0; i < cuts.places.size(); ++i) {
      const int vertex = mesh.source.vertex_count() + static_cast<int>(i);
      if (guard.allows(vertex, result.map[vertex])) {
        kept.places.push_back(cuts.places[i]);
        kept.goals.push_back(cuts.goals[i]);
      } else {
        uncuttable.insert(std::minmax(cuts.places[i].a, cuts.places[i].b));
      }
    }
    if (kept.places.size() == cuts.places.size()) return result;
    cuts = std::move(kept);
  }
}

}  // namespace partwise
