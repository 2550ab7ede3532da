#include "deform/smoothed_rotations.h"

#include <algorithm>

#include "deform/facet_transform.h"
#include "error.h"
#include "geometry/normals.h"
#include "solve/sparse_cholesky.h"

namespace partwise {
namespace {

Vec3 centroid(const TriMesh& mesh, int facet) {
  const auto& [a, b, c] = mesh.facet(facet);
  return (mesh.point(a) + mesh.point(b) + mesh.point(c)) / 3;
}

/// Areas plus reach^2 times the Laplacian between facets, whose weights are an edge's length over the
/// distance from centroid to centroid; lower triangle.
Eigen::SparseMatrix<double> diffusion(const TriMesh& mesh, const std::vector<double>& areas, double reach) {
  const double least = 1e-6 * mesh.diagonal();
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(6 * static_cast<std::size_t>(mesh.facet_count()));
  for (int f = 0; f < mesh.facet_count(); ++f) entries.emplace_back(f, f, areas[f]);
  const HalfEdges& half_edges = mesh.half_edges();
  for (const auto e : half_edges.edges()) {
    const auto h = half_edges.halfedge_handle(e, 0);
    const int f = half_edges.face_handle(h).idx(), g = half_edges.opposite_face_handle(h).idx();
    if (f < 0 || g < 0) continue;
    const Vec3& from = mesh.point(half_edges.from_vertex_handle(h).idx());
    const double length = (mesh.point(half_edges.to_vertex_handle(h).idx()) - from).norm();
    const Vec3 middle = from + (mesh.point(half_edges.to_vertex_handle(h).idx()) - from) / 2;
    const double distance = (centroid(mesh, f) - middle).norm() + (centroid(mesh, g) - middle).norm();
    const double weight = reach * reach * std::max(length, least) / std::max(distance, least);
    entries.emplace_back(f, f, weight);
    entries.emplace_back(g, g, weight);
    entries.emplace_back(std::max(f, g), std::min(f, g), -weight);
  }
  Eigen::SparseMatrix<double> lower(mesh.facet_count(), mesh.facet_count());
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

}  // namespace

std::vector<Eigen::Matrix3d> smoothed_rotations(const TriMesh& mesh,
                                                const std::vector<Eigen::Matrix3d>& rotations,
                                                const std::vector<bool>& known, double reach) {
  const double least = 1e-9 * mesh.diagonal() * mesh.diagonal();
  std::vector<double> areas = facet_areas(mesh.points(), mesh.facets());
  for (std::size_t f = 0; f < areas.size(); ++f) areas[f] = std::max(known[f] ? areas[f] : 0.0, least);
  SparseCholesky factor;
  if (!factor.factorize(diffusion(mesh, areas, reach))) {
    throw ComputationError("rotations cannot be compared: the model has coordinates out of range");
  }
  Eigen::MatrixXd right(mesh.facet_count(), 9);
  for (int f = 0; f < mesh.facet_count(); ++f) {
    right.row(f) = areas[f] * Eigen::Map<const Eigen::Matrix<double, 1, 9>>(rotations[f].data());
  }
  const Eigen::MatrixXd solution = factor.solve(right);
  std::vector<Eigen::Matrix3d> smooth;
  for (int f = 0; f < mesh.facet_count(); ++f) {
    const Eigen::Matrix<double, 1, 9> row = solution.row(f);
    smooth.push_back(nearest_rotation(Eigen::Map<const Eigen::Matrix3d>(row.data())).value_or(rotations[f]));
  }
  return smooth;
}

}  // namespace partwise
