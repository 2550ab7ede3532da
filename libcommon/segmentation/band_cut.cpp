#include "segmentation/band_cut.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/normals.h"
#include "segmentation/crease_field.h"
#include "segmentation/minimum_cut.h"

namespace partwise {
namespace {

constexpr int kCandidates = 4;

class BandCut {
 public:
  BandCut(const TriMesh& mesh, const Seeds& seeds, const PartProbabilities& probabilities,
          const std::vector<double>& boundary_costs, const BandCutOptions& options);

  /// Lets free facets change to `part` where that lowers the sum. \return whether any did
  bool expand(int part);

  std::vector<int> labels() && { return std::move(labels_); }

 private:
  struct Candidate {
    int part = -1;
    double cost = 0;
  };

  const Candidate* candidate(int facet, int part) const;
  double label_cost(int facet) const { return candidate(facet, labels_[facet])->cost; }

  const TriMesh& mesh_;
  const std::vector<double>& boundary_costs_;
  std::vector<int> labels_;
  std::vector<int> free_facets_;
  std::vector<std::array<Candidate, kCandidates>>
      candidates_;  // per facet, unused for those that keep their part
};

BandCut::BandCut(const TriMesh& mesh, const Seeds& seeds, const PartProbabilities& probabilities,
                 const std::vector<double>& boundary_costs, const BandCutOptions& options)
    : mesh_(mesh),
      boundary_costs_(boundary_costs),
      labels_(most_probable_parts(probabilities)),
      candidates_(labels_.size()) {
  const std::vector<double> areas = facet_areas(mesh.points(), mesh.facets());
  const double h = mean_edge_length(mesh);
  const auto part_count = static_cast<int>(probabilities.cols());
  std::vector<int> order(part_count);
  for (int f = 0; f < mesh.facet_count(); ++f) {
    if (seeds.facet_part[f] != kUnseeded) continue;
    for (int k = 0; k < part_count; ++k) order[k] = k;
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return probabilities(f, a) > probabilities(f, b); });
    std::swap(*std::find(order.begin(), order.end(), labels_[f]), order.front());  // ties as in labels_
    if (part_count < 2) continue;
    const double first = probabilities(f, order[0]), second = probabilities(f, order[1]);
    if (second <= options.band * first) continue;
    free_facets_.push_back(f);
    const double weight = options.probability_weight * std::sqrt(areas[f]) / h;
    for (int k = 0; k < std::min(part_count, kCandidates); ++k) {
      const double probability = probabilities(f, order[k]);
      if (!(probability > 0)) break;
      candidates_[f][k] = {order[k], weight * (second / probability - second / first)};
    }
  }
}

const BandCut::Candidate* BandCut::candidate(int facet, int part) const {
  const auto& candidates = candidates_[facet];
  const auto found =
      std::find_if(candidates.begin(), candidates.end(), [&](const Candidate& c) { return c.part == part; });
  return found == candidates.end() ? nullptr : &*found;
}

bool BandCut::expand(int part) {
  std::vector<int> variables(mesh_.facet_count(), -1);
  std::vector<int> facets;
  for (const int f : free_facets_) {
    if (labels_[f] == part || candidate(f, part) == nullptr) continue;
    variables[f] = static_cast<int>(facets.size());
    facets.push_back(f);
  }
  if (facets.empty()) return false;
  BinaryCut cut(static_cast<int>(facets.size()));
  const HalfEdges& half_edges = mesh_.half_edges();
  for (const int f : facets) {
    cut.add_cost(variables[f], candidate(f, part)->cost - label_cost(f));
    for (const auto h : half_edges.fh_range(OpenMesh::FaceHandle(f))) {
      const auto across = half_edges.opposite_face_handle(h);
      if (!across.is_valid()) continue;
      const int g = across.idx();
      const double cost = boundary_costs_[half_edges.edge_handle(h).idx()];
      if (variables[g] < 0) {
        cut.add_cost(variables[f], (labels_[g] != part ? cost : 0) - (labels_[g] != labels_[f] ? cost : 0));
      } else if (f < g) {
        // Costs for (x_f, x_g): both keep, one changes (either way: a boundary to `part`), both change
        // (none).
        const double both_keep = labels_[f] != labels_[g] ? cost : 0;
        cut.add_cost(variables[f], cost - both_keep);
        cut.add_cost(variables[g], -cost);
        cut.add_pair_cost(variables[f], variables[g], 2 * cost - both_keep);
      }
    }
  }
  const std::vector<bool> changes = cut.minimise();
  for (std::size_t i = 0; i < facets.size(); ++i) {
    if (changes[i]) labels_[facets[i]] = part;
  }
  return std::find(changes.begin(), changes.end(), true) != changes.end();
}

}  // namespace

std::vector<int> cut_band(const TriMesh& mesh, const Seeds& seeds, const PartProbabilities& probabilities,
                          const std::vector<double>& boundary_costs, const BandCutOptions& options) {
  BandCut cut(mesh, seeds, probabilities, boundary_costs, options);
  bool changed = true;
  for (int round = 0; round < options.most_rounds && changed; ++round) {
    changed = false;
    for (int part = 0; part < static_cast<int>(probabilities.cols()); ++part) changed |= cut.expand(part);
  }
  return std::move(cut).labels();
}

}  // namespace partwise
