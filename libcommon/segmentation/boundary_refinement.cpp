#include "segmentation/boundary_refinement.h"

#include <cmath>
#include <queue>
#include <tuple>
#include <utility>

namespace partwise {
namespace {

/// A way of length `distance` over the surface from part `part` to `facet`, which belongs to another.
struct Way {
  double distance;
  int facet;
  int part;
  bool operator<(const Way& other) const {  // a priority queue yields the shortest first
    return std::tie(other.distance, other.facet, other.part) < std::tie(distance, facet, part);
  }
};

class Band {
 public:
  Band(const TriMesh& mesh, const std::vector<int>& labels) : mesh_(mesh), labels_(labels) {}

  /// Per facet its own part with odds 1, and every other part closer than `width` with its odds.
  PartProbabilities probabilities(int part_count, double width) {
    PartProbabilities odds = PartProbabilities::Zero(mesh_.facet_count(), part_count);
    start(width);
    while (!ways_.empty()) {
      const Way way = ways_.top();
      ways_.pop();
      double& known = odds(way.facet, way.part);
      if (known > 0) continue;
      known = std::exp(-1.2 * way.distance / width);
      step_on(way, width);
    }
    for (int f = 0; f < mesh_.facet_count(); ++f) odds(f, labels_[f]) = 1;
    for (int f = 0; f < mesh_.facet_count(); ++f) odds.row(f) /= odds.row(f).sum();
    return odds;
  }

 private:
  Vec3 centroid(int f) const {
    const auto& [a, b, c] = mesh_.facet(f);
    return (mesh_.point(a) + mesh_.point(b) + mesh_.point(c)) / 3;
  }

  Vec3 middle(OpenMesh::HalfedgeHandle h) const {
    const HalfEdges& half_edges = mesh_.half_edges();
    return (mesh_.point(half_edges.from_vertex_handle(h).idx()) +
            mesh_.point(half_edges.to_vertex_handle(h).idx())) /
           2;
  }

  void push(const Way& way, double width) {
    if (labels_[way.facet] != way.part && way.distance < width) ways_.push(way);
  }

  void start(double width) {
    const HalfEdges& half_edges = mesh_.half_edges();
    for (const auto h : half_edges.halfedges()) {
      const int from = half_edges.face_handle(h).idx();
      const int to = half_edges.face_handle(half_edges.opposite_halfedge_handle(h)).idx();
      if (from < 0 || to < 0 || labels_[from] == labels_[to]) continue;
      push({(centroid(to) - middle(h)).norm(), to, labels_[from]}, width);
    }
  }

  void step_on(const Way& way, double width) {
    const HalfEdges& half_edges = mesh_.half_edges();
    for (const auto h : half_edges.fh_range(OpenMesh::FaceHandle(way.facet))) {
      const int to = half_edges.face_handle(half_edges.opposite_halfedge_handle(h)).idx();
      if (to < 0) continue;
      const Vec3 m = middle(h);
      push({way.distance + (m - centroid(way.facet)).norm() + (centroid(to) - m).norm(), to, way.part},
           width);
    }
  }

  const TriMesh& mesh_;
  const std::vector<int>& labels_;
  std::priority_queue<Way> ways_;
};

}  // namespace

std::vector<int> refine_boundaries(const TriMesh& mesh, const Seeds& seeds, int part_count,
                                   std::vector<int> labels, const std::vector<double>& boundary_costs,
                                   const RefinementOptions& options) {
  const double width = options.width * mesh.diagonal();
  for (int round = 0; round < options.rounds; ++round) {
    const PartProbabilities odds = Band(mesh, labels).probabilities(part_count, width);
    std::vector<int> next = cut_band(mesh, seeds, odds, boundary_costs, options.band_cut);
    const bool is_settled = next == labels;
    labels = std::move(next);
    if (is_settled) break;
  }
  return labels;
}

}  // namespace partwise
