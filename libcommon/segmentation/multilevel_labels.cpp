#include "segmentation/multilevel_labels.h"

#include <algorithm>
#include <utility>

namespace partwise {
namespace {

constexpr int kCutRings = 3;   // beside a boundary, where nodes may change their part
constexpr int kWalkRings = 6;  // where probabilities are computed anew
constexpr int kWalkSteps = 8;  // of averaging
constexpr int kMixed = -2;     // a group with seeds of several parts

/// Nodes of one level near a boundary, as a graph of its own: the band, then its rim.
struct Band {
  std::vector<int> nodes;  // of the level
  std::vector<int> index;  // per node of the level: where in `nodes`, or -1
  int inner = 0;           // nodes within kCutRings come first
  int band = 0;            // then those within kWalkRings, then the rim
  FacetGraph graph;
};

void add_ring(const FacetGraph& graph, Band& band, std::size_t& done) {
  for (const std::size_t end = band.nodes.size(); done < end; ++done) {
    const int i = band.nodes[done];
    for (int k = graph.first[i]; k < graph.first[i + 1]; ++k) {
      const int j = graph.neighbour[k];
      if (band.index[j] >= 0) continue;
      band.index[j] = static_cast<int>(band.nodes.size());
      band.nodes.push_back(j);
    }
  }
}

Band band_around_boundaries(const FacetGraph& graph, const std::vector<int>& labels) {
  Band band;
  band.index.assign(graph.node_count(), -1);
  for (int i = 0; i < graph.node_count(); ++i) {
    for (int k = graph.first[i]; k < graph.first[i + 1]; ++k) {
      if (labels[graph.neighbour[k]] == labels[i]) continue;
      band.index[i] = static_cast<int>(band.nodes.size());
      band.nodes.push_back(i);
      break;
    }
  }
  std::size_t done = 0;
  for (int ring = 1; ring < kCutRings; ++ring) add_ring(graph, band, done);
  band.inner = static_cast<int>(band.nodes.size());
  for (int ring = kCutRings; ring < kWalkRings; ++ring) add_ring(graph, band, done);
  band.band = static_cast<int>(band.nodes.size());
  add_ring(graph, band, done);
  for (std::size_t b = 0; b < band.nodes.size(); ++b) {
    const int i = band.nodes[b];
    for (int k = graph.first[i]; k < graph.first[i + 1]; ++k) {
      if (band.index[graph.neighbour[k]] < 0) continue;
      band.graph.neighbour.push_back(band.index[graph.neighbour[k]]);
      band.graph.conductance.push_back(graph.conductance[k]);
      band.graph.cut_cost.push_back(graph.cut_cost[k]);
    }
    band.graph.first.push_back(static_cast<int>(band.graph.neighbour.size()));
    band.graph.size.push_back(graph.size[i]);
  }
  return band;
}

class Refinement {
 public:
  Refinement(const FacetHierarchy& hierarchy, const std::vector<FacetGraph>& graphs,
             const std::vector<int>& facet_seeds, int part_count, const BandCutOptions& options)
      : hierarchy_(hierarchy),
        graphs_(graphs),
        part_count_(part_count),
        options_(options),
        near_(graphs.size()) {
    collect_seeds(facet_seeds);
  }

  std::vector<int> labels() {
    std::vector<int> labels = solve_coarsest();
    for (int level = static_cast<int>(graphs_.size()) - 2; level >= 0; --level) {
      std::vector<int> finer(graphs_[level].node_count());
      for (std::size_t i = 0; i < finer.size(); ++i) {
        const int seed = seeds_[level][i];
        finer[i] = seed >= 0 ? seed : labels[hierarchy_.levels()[level].parent[i]];
      }
      labels = std::move(finer);
      refine(level, labels);
    }
    return labels;
  }

 private:
  /// What is known of the probabilities of a level: those of its band.
  struct Near {
    std::vector<int> index;  // per node its row, or -1
    PartProbabilities rows;
  };

  void collect_seeds(const std::vector<int>& facet_seeds);
  std::vector<int> solve_coarsest();
  void refine(int level, std::vector<int>& labels);
  Eigen::RowVectorXd probabilities(int level, int node) const;

  const FacetHierarchy& hierarchy_;
  const std::vector<FacetGraph>& graphs_;
  int part_count_;
  const BandCutOptions& options_;
  std::vector<std::vector<int>> seeds_;  // per level, per node: part, kUnseeded or kMixed
  PartProbabilities coarsest_seeds_;     // per node of the coarsest level: number of seeded facets by part
  std::vector<Near> near_;               // per level
  PartProbabilities coarsest_;
};

void Refinement::collect_seeds(const std::vector<int>& facet_seeds) {
  for (const FacetGraph& graph : graphs_) seeds_.emplace_back(graph.node_count(), kUnseeded);
  coarsest_seeds_ = PartProbabilities::Zero(graphs_.back().node_count(), part_count_);
  for (std::size_t f = 0; f < facet_seeds.size(); ++f) {
    const int part = facet_seeds[f];
    if (part == kUnseeded) continue;
    int node = static_cast<int>(f);
    for (std::size_t level = 0; level < graphs_.size(); ++level) {
      int& seed = seeds_[level][node];
      seed = seed == kUnseeded || seed == part ? part : kMixed;
      if (level + 1 < graphs_.size()) node = hierarchy_.levels()[level].parent[node];
    }
    coarsest_seeds_(node, part) += 1;
  }
}

/// Groups with seeds of several parts are fixed to the shares of their seeds.
std::vector<int> Refinement::solve_coarsest() {
  const FacetGraph& graph = graphs_.back();
  std::vector<bool> is_fixed(graph.node_count()), is_pure(graph.node_count());
  PartProbabilities values = coarsest_seeds_;
  for (int i = 0; i < graph.node_count(); ++i) {
    is_fixed[i] = seeds_.back()[i] != kUnseeded;
    is_pure[i] = seeds_.back()[i] >= 0;
    if (is_fixed[i]) values.row(i) /= values.row(i).sum();
  }
  coarsest_ = walk_randomly(graph, is_fixed, std::move(values));
  return cut_band(graph, nodes_in_doubt(is_pure, coarsest_, options_.band), most_probable_parts(coarsest_),
                  coarsest_, options_);
}

Eigen::RowVectorXd Refinement::probabilities(int level, int node) const {
  for (; level + 1 < static_cast<int>(graphs_.size()); ++level) {
    if (!near_[level].index.empty() && near_[level].index[node] >= 0) {
      return near_[level].rows.row(near_[level].index[node]);
    }
    node = hierarchy_.levels()[level].parent[node];
  }
  return coarsest_.row(node);
}

void Refinement::refine(int level, std::vector<int>& labels) {
  Band band = band_around_boundaries(graphs_[level], labels);
  const auto count = static_cast<int>(band.nodes.size());
  PartProbabilities values(count, part_count_);
  std::vector<bool> is_fixed(count), is_free(count);
  std::vector<int> near_labels(count);
  for (int b = 0; b < count; ++b) {
    const int node = band.nodes[b], seed = seeds_[level][node];
    near_labels[b] = labels[node];
    is_fixed[b] = b >= band.band || seed >= 0;
    is_free[b] = b < band.inner && seed < 0;
    values.row(b) = probabilities(level, node);
    if (seed >= 0) values.row(b) = Eigen::RowVectorXd::Unit(part_count_, seed);
  }
  values = average_neighbours(band.graph, is_fixed, std::move(values), kWalkSteps);
  near_labels = cut_band(band.graph, is_free, std::move(near_labels), values, options_);
  for (int b = 0; b < count; ++b) labels[band.nodes[b]] = near_labels[b];
  near_[level] = {std::move(band.index), std::move(values)};
}

}  // namespace

std::vector<int> label_on_levels(const FacetHierarchy& hierarchy, const std::vector<FacetGraph>& graphs,
                                 const std::vector<int>& facet_seeds, int part_count,
                                 const BandCutOptions& options) {
  return Refinement(hierarchy, graphs, facet_seeds, part_count, options).labels();
}

}  // namespace partwise
