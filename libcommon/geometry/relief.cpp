#include "geometry/relief.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "error.h"
#include "geometry/curvature.h"
#include "geometry/edge_cotangent.h"
#include "geometry/normals.h"
#include "solve/sparse_cholesky.h"

namespace partwise {
namespace {

constexpr std::array<double, 3> kRadii{0.01, 0.02, 0.04};  // over the diagonal
constexpr double kLeastMass = 1e-6;                        // of a vertex, over the mean

/// Of cotangents, positive semidefinite; the lower triangle.
Eigen::SparseMatrix<double> cotangent_laplacian(const TriMesh& mesh) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(9 * mesh.facets().size());
  for (const Facet& f : mesh.facets()) {
    for (int i = 0; i < 3; ++i) {
      const int apex = f[i], a = f[(i + 1) % 3], b = f[(i + 2) % 3];
      const double weight =
          bounded_half_cotangent(mesh.point(a) - mesh.point(apex), mesh.point(b) - mesh.point(apex));
      entries.emplace_back(a, a, weight);
      entries.emplace_back(b, b, weight);
      entries.emplace_back(std::max(a, b), std::min(a, b), -weight);
    }
  }
  Eigen::SparseMatrix<double> laplacian(mesh.vertex_count(), mesh.vertex_count());
  laplacian.setFromTriplets(entries.begin(), entries.end());
  return laplacian;
}

Eigen::VectorXd masses(const TriMesh& mesh) {
  const std::vector<double> areas = mixed_areas(mesh);
  const Eigen::VectorXd mass = Eigen::Map<const Eigen::VectorXd>(areas.data(), mesh.vertex_count());
  return mass.cwiseMax(kLeastMass * mass.mean());
}

}  // namespace

std::vector<Vec3> relief(const TriMesh& mesh) {
  const int count = mesh.vertex_count();
  const Points normals = vertex_normals(mesh.points(), mesh.facets());
  const Eigen::SparseMatrix<double> laplacian = cotangent_laplacian(mesh);
  const Eigen::VectorXd mass = masses(mesh);
  Eigen::MatrixX3d places(count, 3);
  for (int v = 0; v < count; ++v) places.row(v) = mesh.point(v).transpose();
  std::vector<Vec3> result(count);
  SparseCholesky solver(CholeskyBlocks::where_quicker);
  for (std::size_t i = 0; i < kRadii.size(); ++i) {
    const double radius = kRadii[i] * mesh.diagonal();
    Eigen::SparseMatrix<double> flow = radius * radius * laplacian;
    flow.diagonal() += mass;
    if (!solver.factorize(flow)) throw ComputationError("heat does not flow over the mesh: it has no area");
    const Eigen::MatrixXd smooth = solver.solve(mass.asDiagonal() * places);
    for (int v = 0; v < count; ++v) {
      result[v][static_cast<int>(i)] = (places.row(v) - smooth.row(v)).dot(normals[v].transpose()) / radius;
    }
  }
  return result;
}

}  // namespace partwise
