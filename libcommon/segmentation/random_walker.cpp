#include "segmentation/random_walker.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>

#include "error.h"
#include "segmentation/crease_field.h"

namespace partwise {
namespace {

using OpenMesh::EdgeHandle;
using OpenMesh::HalfedgeHandle;

/// Two facets that share edge `edge`.
struct DualEdge {
  int a;
  int b;
  int edge;
};

std::vector<DualEdge> dual_edges(const TriMesh& mesh) {
  const HalfEdges& half_edges = mesh.half_edges();
  std::vector<DualEdge> result;
  for (int e = 0; e < static_cast<int>(half_edges.n_edges()); ++e) {
    const auto a = half_edges.face_handle(half_edges.halfedge_handle(EdgeHandle(e), 0));
    const auto b = half_edges.face_handle(half_edges.halfedge_handle(EdgeHandle(e), 1));
    if (a.is_valid() && b.is_valid()) result.push_back({a.idx(), b.idx(), e});
  }
  return result;
}

double crossing_weight(const TriMesh& mesh, const DualEdge& dual, double concavity) {
  const HalfedgeHandle h = mesh.half_edges().halfedge_handle(EdgeHandle(dual.edge), 0);
  const Vec3& from = mesh.point(mesh.half_edges().from_vertex_handle(h).idx());
  const Vec3& to = mesh.point(mesh.half_edges().to_vertex_handle(h).idx());
  const Vec3 middle = (from + to) / 2;
  auto centroid = [&](int f) -> Vec3 {
    const auto& [a, b, c] = mesh.facet(f);
    return (mesh.point(a) + mesh.point(b) + mesh.point(c)) / 3;
  };
  const double way = (centroid(dual.a) - middle).norm() + (middle - centroid(dual.b)).norm();
  // Slivers and facets without area would give weights that no double-precision system carries.
  const double ratio = std::clamp((to - from).norm() / std::max(way, 1e-300), 1e-4, 1e4);
  return ratio * std::exp(-3 * std::min(concavity / 20, 4.0));
}

}  // namespace

PartProbabilities walk_randomly(const TriMesh& mesh, const Seeds& seeds, int part_count,
                                const std::vector<double>& concavity) {
  PartProbabilities probabilities = PartProbabilities::Zero(mesh.facet_count(), part_count);
  std::vector<int> unknown(mesh.facet_count(), -1), facet_of;
  for (int f = 0; f < mesh.facet_count(); ++f) {
    if (seeds.facet_part[f] != kUnseeded) {
      probabilities(f, seeds.facet_part[f]) = 1;
    } else {
      unknown[f] = static_cast<int>(facet_of.size());
      facet_of.push_back(f);
    }
  }
  if (facet_of.empty()) return probabilities;

  const int n = static_cast<int>(facet_of.size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n, part_count);
  auto add = [&](int from, int to, double weight) {
    if (unknown[from] < 0) return;
    entries.emplace_back(unknown[from], unknown[from], weight);
    if (unknown[to] < 0) {
      right(unknown[from], seeds.facet_part[to]) += weight;
    } else {
      entries.emplace_back(unknown[from], unknown[to], -weight);
    }
  };
  for (const DualEdge& dual : dual_edges(mesh)) {
    const double weight = crossing_weight(mesh, dual, concavity[dual.edge]);
    add(dual.a, dual.b, weight);
    add(dual.b, dual.a, weight);
  }
  Eigen::SparseMatrix<double> laplacian(n, n);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(laplacian);
  if (factor.info() != Eigen::Success) {
    throw ComputationError("the random walker's linear system cannot be factorised; try --method growth");
  }
  const Eigen::MatrixXd solution = factor.solve(right);
  for (int i = 0; i < n; ++i) probabilities.row(facet_of[i]) = solution.row(i);
  return probabilities;
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
