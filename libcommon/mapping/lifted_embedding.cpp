#include "mapping/lifted_embedding.h"

#include <cmath>
#include <numbers>
#include <string>

#include "error.h"
#include "solve/sparse_cholesky.h"

namespace partwise {
namespace {

/// Places of the rim's vertices, clockwise: seen from the removed vertex below they turn counterclockwise.
std::vector<Eigen::Vector2d> circle(std::size_t count) {
  std::vector<Eigen::Vector2d> places;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = -2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    places.emplace_back(std::cos(angle), std::sin(angle));
  }
  return places;
}

/// The plane layout: per vertex x, y; zero for the removed one.
Eigen::MatrixX2d lay_out_disc(const TriMesh& mesh, int removed) {
  const HalfEdges& half_edges = mesh.half_edges();
  std::vector<int> rim;
  for (const auto v : half_edges.vv_ccw_range(OpenMesh::VertexHandle(removed))) rim.push_back(v.idx());
  const std::vector<Eigen::Vector2d> places = circle(rim.size());
  Eigen::MatrixX2d layout = Eigen::MatrixX2d::Zero(mesh.vertex_count(), 2);
  std::vector<int> unknowns(mesh.vertex_count(), 0);
  unknowns[removed] = -1;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    unknowns[rim[i]] = -1;
    layout.row(rim[i]) = places[i];
  }
  int count = 0;
  for (int& unknown : unknowns) {
    if (unknown >= 0) unknown = count++;
  }
  if (count == 0) return layout;

  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(count, 2);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (unknowns[v] < 0) continue;
    double degree = 0;
    for (const auto w : half_edges.vv_range(OpenMesh::VertexHandle(v))) {
      ++degree;
      const int other = unknowns[w.idx()];
      if (other < 0) {
        sums.row(unknowns[v]) += layout.row(w.idx());
      } else if (other < unknowns[v]) {
        entries.emplace_back(unknowns[v], other, -1);
      }
    }
    entries.emplace_back(unknowns[v], unknowns[v], degree);
  }
  Eigen::SparseMatrix<double> means(count, count);
  means.setFromTriplets(entries.begin(), entries.end());
  SparseCholesky solver;
  if (!solver.factorize(means)) throw ComputationError("the disc cannot be laid out in double precision");
  const Eigen::MatrixXd solution = solver.solve(sums);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (unknowns[v] >= 0) layout.row(v) = solution.row(unknowns[v]);
  }
  return layout;
}

}  // namespace

Points embed_by_lifting(const TriMesh& mesh, int removed) {
  const Eigen::MatrixX2d layout = lay_out_disc(mesh, removed);
  Points directions;
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    directions.push_back(v == removed ? Vec3(-Vec3::UnitZ())
                                      : Vec3(2 * layout(v, 0), 2 * layout(v, 1), 1).normalized());
  }
  for (int f = 0; f < mesh.facet_count(); ++f) {
    const auto& [a, b, c] = mesh.facet(f);
    const Vec3& p = directions[a];
    if (p.dot((directions[b] - p).cross(directions[c] - p)) > 0) continue;
    throw ComputationError("no place on the sphere for facet " + std::to_string(f) +
                           ": it is too small there for double precision");
  }
  return directions;
}

}  // namespace partwise
