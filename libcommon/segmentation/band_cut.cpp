#include "segmentation/band_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "segmentation/minimum_cut.h"

namespace partwise {
namespace {

constexpr int kCandidates = 4;
constexpr double kLeastShare = 1e-3;  // of the best probability, which a node's present part counts as having

class BandCut {
 public:
  BandCut(const FacetGraph& graph, const std::vector<bool>& is_free, std::vector<int> labels,
          const PartProbabilities& probabilities, const BandCutOptions& options);

  /// Lets free nodes change to `part` where that lowers the sum. \return whether any did
  bool expand(int part);

  std::vector<int> labels() && { return std::move(labels_); }

 private:
  struct Candidate {
    int part = -1;
    double cost = 0;
  };
  using Candidates = std::array<Candidate, kCandidates>;

  static Candidates candidates_of(const PartProbabilities& probabilities, int node, int label, double weight,
                                  std::vector<int>& order);
  static const Candidate* find(const Candidates& candidates, int part);
  void add_link(BinaryCut& cut, int from, int link, int part) const;

  const FacetGraph& graph_;
  std::vector<int> labels_;
  std::vector<int> free_nodes_;
  std::vector<Candidates> candidates_;  // per free node
  std::vector<int> variables_;          // per node: its variable in the expansion at hand, or -1
};

BandCut::BandCut(const FacetGraph& graph, const std::vector<bool>& is_free, std::vector<int> labels,
                 const PartProbabilities& probabilities, const BandCutOptions& options)
    : graph_(graph), labels_(std::move(labels)), variables_(labels_.size(), -1) {
  if (probabilities.cols() < 2) return;
  std::vector<int> order(probabilities.cols());
  for (int i = 0; i < graph.node_count(); ++i) {
    if (!is_free[i]) continue;
    const double weight = options.probability_weight * graph.size[i];
    free_nodes_.push_back(i);
    candidates_.push_back(candidates_of(probabilities, i, labels_[i], weight, order));
  }
}

/// The best parts of a node, its present one among them, and what they cost.
BandCut::Candidates BandCut::candidates_of(const PartProbabilities& probabilities, int node, int label,
                                           double weight, std::vector<int>& order) {
  const auto p = probabilities.row(node);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return p(a) > p(b); });
  const auto present = std::find(order.begin(), order.end(), label);
  if (p(label) + 1e-12 >= p(order.front())) {
    std::swap(*present, order.front());  // a tie
  } else if (present - order.begin() >= kCandidates) {
    std::swap(*present, order[kCandidates - 1]);
  }
  const double first = p(order[0]), second = p(order[1]);
  Candidates candidates;
  for (int k = 0; k < std::min(static_cast<int>(order.size()), kCandidates); ++k) {
    const double probability = order[k] == label ? std::max(p(label), kLeastShare * first) : p(order[k]);
    if (!(probability > 0)) continue;
    candidates[k] = {order[k], weight * (second / probability - second / first)};
  }
  return candidates;
}

const BandCut::Candidate* BandCut::find(const Candidates& candidates, int part) {
  const auto found =
      std::find_if(candidates.begin(), candidates.end(), [&](const Candidate& c) { return c.part == part; });
  return found == candidates.end() ? nullptr : &*found;
}

void BandCut::add_link(BinaryCut& cut, int from, int link, int part) const {
  const int to = graph_.neighbour[link];
  const double cost = graph_.cut_cost[link];
  const int label = labels_[from], other = labels_[to];
  if (variables_[to] < 0) {
    cut.add_cost(variables_[from], (other != part ? cost : 0) - (other != label ? cost : 0));
  } else if (from < to) {
    // Costs for (x_from, x_to): both keep, one changes (either way: a boundary to `part`), both change
    // (none).
    const double both_keep = label != other ? cost : 0;
    cut.add_cost(variables_[from], cost - both_keep);
    cut.add_cost(variables_[to], -cost);
    cut.add_pair_cost(variables_[from], variables_[to], 2 * cost - both_keep);
  }
}

bool BandCut::expand(int part) {
  std::vector<int> nodes;
  std::vector<double> changes_cost;
  for (std::size_t i = 0; i < free_nodes_.size(); ++i) {
    const int node = free_nodes_[i];
    const Candidate* change = labels_[node] == part ? nullptr : find(candidates_[i], part);
    if (change == nullptr) continue;
    variables_[node] = static_cast<int>(nodes.size());
    nodes.push_back(node);
    changes_cost.push_back(change->cost - find(candidates_[i], labels_[node])->cost);
  }
  if (nodes.empty()) return false;
  BinaryCut cut(static_cast<int>(nodes.size()));
  for (std::size_t v = 0; v < nodes.size(); ++v) {
    cut.add_cost(static_cast<int>(v), changes_cost[v]);
    for (int k = graph_.first[nodes[v]]; k < graph_.first[nodes[v] + 1]; ++k) {
      add_link(cut, nodes[v], k, part);
    }
  }
  const std::vector<bool> changes = cut.minimise();
  for (std::size_t v = 0; v < nodes.size(); ++v) {
    if (changes[v]) labels_[nodes[v]] = part;
    variables_[nodes[v]] = -1;
  }
  return std::find(changes.begin(), changes.end(), true) != changes.end();
}

}  // namespace

std::vector<bool> nodes_in_doubt(const std::vector<bool>& is_fixed, const PartProbabilities& probabilities,
                                 double band) {
  std::vector<bool> in_doubt(is_fixed.size(), false);
  for (std::size_t i = 0; i < in_doubt.size(); ++i) {
    double first = 0, second = 0;
    for (const double p : probabilities.row(static_cast<Eigen::Index>(i))) {
      second = std::max(second, std::min(first, p));
      first = std::max(first, p);
    }
    in_doubt[i] = !is_fixed[i] && second > band * first;
  }
  return in_doubt;
}

std::vector<int> cut_band(const FacetGraph& graph, const std::vector<bool>& is_free, std::vector<int> labels,
                          const PartProbabilities& probabilities, const BandCutOptions& options) {
  BandCut cut(graph, is_free, std::move(labels), probabilities, options);
  bool changed = true;
  for (int round = 0; round < options.most_rounds && changed; ++round) {
    changed = false;
    for (int part = 0; part < static_cast<int>(probabilities.cols()); ++part) changed |= cut.expand(part);
  }
  return std::move(cut).labels();
}

std::vector<int> cut_band(const TriMesh& mesh, const Seeds& seeds, const PartProbabilities& probabilities,
                          const std::vector<double>& boundary_costs, const BandCutOptions& options) {
  std::vector<bool> is_seeded(mesh.facet_count());
  for (int f = 0; f < mesh.facet_count(); ++f) is_seeded[f] = seeds.facet_part[f] != kUnseeded;
  const std::vector<double> flat(mesh.half_edges().n_edges(), 0.0);
  return cut_band(facet_graph(mesh, flat, boundary_costs),
                  nodes_in_doubt(is_seeded, probabilities, options.band), most_probable_parts(probabilities),
                  probabilities, options);
}

}  // namespace partwise
