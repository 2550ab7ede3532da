#include "segmentation/random_walker.h"

#include <algorithm>
#include <utility>

#include "error.h"
#include "solve/sparse_cholesky.h"

namespace partwise {
namespace {

/// The walker's equations over the free nodes.
struct WalkSystem {
  std::vector<int> node_of;  // per unknown
  Eigen::SparseMatrix<double> lower;
  Eigen::MatrixXd right;
};

WalkSystem walk_system(const FacetGraph& graph, const std::vector<bool>& is_fixed,
                       const PartProbabilities& values) {
  WalkSystem system;
  std::vector<int> unknown(graph.node_count(), -1);
  for (int i = 0; i < graph.node_count(); ++i) {
    if (is_fixed[i]) continue;
    unknown[i] = static_cast<int>(system.node_of.size());
    system.node_of.push_back(i);
  }
  const auto n = static_cast<Eigen::Index>(system.node_of.size());
  system.right = Eigen::MatrixXd::Zero(n, values.cols());
  system.lower.resize(n, n);
  system.lower.reserve(n + static_cast<Eigen::Index>(graph.neighbour.size()) / 2);
  std::vector<std::pair<int, double>> column;  // below the diagonal
  for (Eigen::Index u = 0; u < n; ++u) {
    const int i = system.node_of[u];
    double diagonal = 0;
    column.clear();
    for (int k = graph.first[i]; k < graph.first[i + 1]; ++k) {
      const int j = graph.neighbour[k];
      diagonal += graph.conductance[k];
      if (is_fixed[j]) {
        system.right.row(u) += graph.conductance[k] * values.row(j);
      } else if (unknown[j] > u) {
        column.emplace_back(unknown[j], -graph.conductance[k]);
      }
    }
    std::sort(column.begin(), column.end());
    system.lower.startVec(u);
    system.lower.insertBack(u, u) = diagonal;
    for (std::size_t k = 0; k < column.size(); ++k) {
      // Two facets may share two edges.
      if (k > 0 && column[k].first == column[k - 1].first) {
        system.lower.valuePtr()[system.lower.nonZeros() - 1] += column[k].second;
      } else {
        system.lower.insertBack(column[k].first, u) = column[k].second;
      }
    }
  }
  system.lower.finalize();
  return system;
}

}  // namespace

PartProbabilities walk_randomly(const FacetGraph& graph, const std::vector<bool>& is_fixed,
                                PartProbabilities values) {
  const WalkSystem system = walk_system(graph, is_fixed, values);
  if (system.node_of.empty()) return values;
  SparseCholesky factor(CholeskyBlocks::where_quicker);
  if (!factor.factorize(system.lower)) {
    throw ComputationError("the random walker's linear system cannot be factorised; try --method growth");
  }
  const Eigen::MatrixXd solution = factor.solve(system.right);
  for (std::size_t u = 0; u < system.node_of.size(); ++u) {
    values.row(system.node_of[u]) = solution.row(static_cast<Eigen::Index>(u));
  }
  return values;
}

PartProbabilities walk_randomly(const TriMesh& mesh, const Seeds& seeds, int part_count,
                                const std::vector<double>& concavity) {
  PartProbabilities values = PartProbabilities::Zero(mesh.facet_count(), part_count);
  std::vector<bool> is_fixed(mesh.facet_count(), false);
  for (int f = 0; f < mesh.facet_count(); ++f) {
    if (seeds.facet_part[f] == kUnseeded) continue;
    is_fixed[f] = true;
    values(f, seeds.facet_part[f]) = 1;
  }
  const std::vector<double> no_costs(mesh.half_edges().n_edges(), 0.0);
  return walk_randomly(facet_graph(mesh, concavity, no_costs), is_fixed, std::move(values));
}

PartProbabilities average_neighbours(const FacetGraph& graph, const std::vector<bool>& is_fixed,
                                     PartProbabilities values, int steps) {
  PartProbabilities before;
  for (int step = 0; step < steps; ++step) {
    before = values;
    for (int i = 0; i < graph.node_count(); ++i) {
      if (is_fixed[i]) continue;
      double sum = 0;
      values.row(i).setZero();
      for (int k = graph.first[i]; k < graph.first[i + 1]; ++k) {
        values.row(i) += graph.conductance[k] * before.row(graph.neighbour[k]);
        sum += graph.conductance[k];
      }
      if (sum > 0) {
        values.row(i) /= sum;
      } else {
        values.row(i) = before.row(i);
      }
    }
  }
  return values;
}

std::vector<int> most_probable_parts(const PartProbabilities& probabilities) {
  std::vector<int> labels(probabilities.rows(), 0);
  for (Eigen::Index f = 0; f < probabilities.rows(); ++f) {
    for (int part = 1; part < probabilities.cols(); ++part) {
      if (probabilities(f, part) > probabilities(f, labels[f]) + 1e-12) labels[f] = part;
    }
  }
  return labels;
}

}  // namespace partwise
