#include "deform/held_points.h"

#include <algorithm>
#include <set>
#include <utility>

#include "error.h"
#include "geometry/normals.h"

namespace partwise {
namespace {

/// A third of the area around each vertex.
std::vector<double> vertex_areas(const TriMesh& mesh) {
  const std::vector<double> of_facets = facet_areas(mesh.points(), mesh.facets());
  std::vector<double> areas(mesh.vertex_count(), 0);
  for (int f = 0; f < mesh.facet_count(); ++f) {
    for (const int v : mesh.facet(f)) areas[v] += of_facets[f] / 3;
  }
  return areas;
}

/// Subtracts the mean over each component, by area, and multiplies by the area.
void weigh_without_mean(Eigen::Ref<Eigen::VectorXd> field, const std::vector<int>& components, int count,
                        const std::vector<double>& areas) {
  std::vector<double> sums(count, 0), totals(count, 0);
  for (Eigen::Index v = 0; v < field.size(); ++v) {
    sums[components[v]] += areas[v] * field[v];
    totals[components[v]] += areas[v];
  }
  for (Eigen::Index v = 0; v < field.size(); ++v) {
    const int k = components[v];
    field[v] = areas[v] * (field[v] - (totals[k] > 0 ? sums[k] / totals[k] : 0));
  }
}

/// Row `row` of any table by vertex, at a point of the surface.
template <class Table>
Eigen::RowVectorXd at_point(const Table& table, const Facets& facets, const SurfacePoint& point) {
  Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(table.cols());
  for (int i = 0; i < 3; ++i) sum += point.barycentric[i] * table.row(facets[point.facet][i]);
  return sum;
}

Eigen::MatrixXd matrix_of(const Points& points) {
  Eigen::MatrixXd matrix(points.size(), 3);
  for (std::size_t v = 0; v < points.size(); ++v)
    matrix.row(static_cast<Eigen::Index>(v)) = points[v].transpose();
  return matrix;
}

}  // namespace

HeldPoints::HeldPoints(const TriMesh& mesh, const SurfaceIntegration& integration,
                       std::vector<SurfacePoint> points)
    : facets_(mesh.facets()), points_(std::move(points)), components_(integration.components()) {
  const auto count = static_cast<Eigen::Index>(points_.size());
  const std::vector<double> areas = vertex_areas(mesh);
  // The Green's function of the squared Laplacian, where pulls add up to nothing over each component.
  Eigen::MatrixXd pulls = Eigen::MatrixXd::Zero(mesh.vertex_count(), count);
  std::set<int> held;
  for (Eigen::Index j = 0; j < count; ++j) {
    const Facet& facet = mesh.facet(points_[j].facet);
    for (int i = 0; i < 3; ++i) pulls(facet[i], j) += points_[j].barycentric[i];
    held.insert(components_[facet[0]]);
  }
  fields_ = integration.solve(pulls);
  for (Eigen::Index j = 0; j < count; ++j) {
    weigh_without_mean(fields_.col(j), components_, integration.component_count(), areas);
  }
  fields_ = integration.solve(fields_);
  held_.assign(held.begin(), held.end());

  const auto moves = static_cast<Eigen::Index>(held_.size());
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(count + moves, count + moves);
  for (Eigen::Index i = 0; i < count; ++i) {
    system.row(i).head(count) = at_point(fields_, facets_, points_[i]);
    const int component = components_[facets_[points_[i].facet][0]];
    const auto move = std::lower_bound(held_.begin(), held_.end(), component) - held_.begin();
    system(i, count + move) = system(count + move, i) = 1;
  }
  // Places and pulls differ in size by far; one scale for all keeps the rank's meaning.
  const double size = system.topLeftCorner(count, count).cwiseAbs().maxCoeff();
  if (size > 0) {
    fields_ /= size;
    system.topLeftCorner(count, count) /= size;
  }
  system_.setThreshold(1e-12);
  system_.compute(system);
  if (!system_.isInvertible()) throw InputError("two of the points to hold are at the same place");
}

Points HeldPoints::corrected(Points positions, const Points& places) const {
  const auto count = static_cast<Eigen::Index>(points_.size());
  const Eigen::MatrixXd now = matrix_of(positions);
  Eigen::MatrixXd gaps = Eigen::MatrixXd::Zero(count + static_cast<Eigen::Index>(held_.size()), 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    gaps.row(i) = places[i].transpose() - at_point(now, facets_, points_[i]);
  }
  const Eigen::MatrixXd solution = system_.solve(gaps);
  const Eigen::MatrixXd correction = fields_ * solution.topRows(count);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const auto move = std::lower_bound(held_.begin(), held_.end(), components_[v]) - held_.begin();
    if (move == static_cast<Eigen::Index>(held_.size()) || held_[move] != components_[v]) continue;
    positions[v] += (correction.row(static_cast<Eigen::Index>(v)) + solution.row(count + move)).transpose();
  }
  return positions;
}

}  // namespace partwise
