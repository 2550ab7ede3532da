#include "mapping/relax_on_hull.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "energy/symmetric_dirichlet.h"
#include "error.h"
#include "mapping/hull_references.h"
#include "solve/facet_hessians.h"
#include "solve/sparse_cholesky.h"

namespace partwise {
namespace {

using Places = std::vector<StarHull::Place>;
using LocalHessian = FacetHessians::Block;
using LocalGradient = Eigen::Matrix<double, 6, 1>;

/// Replaces negative curvature by positive, so that the Newton step is a descent.
void make_positive(LocalHessian& hessian) {
  // Most blocks are positive already, up to the zero curvature of moving a facet as a whole: a Cholesky
  // factorisation says so at a tenth of the cost of eigenvalues.
  const LocalHessian lifted =
      hessian + 1e-9 * hessian.diagonal().cwiseAbs().maxCoeff() * LocalHessian::Identity();
  if (lifted.llt().info() == Eigen::Success) {
    hessian = lifted;
    return;
  }
  Eigen::SelfAdjointEigenSolver<LocalHessian> eigen(hessian);
  if (eigen.eigenvalues()[0] > 0) return;
  const LocalGradient values = eigen.eigenvalues().cwiseMax(1e-9 * eigen.eigenvalues().cwiseAbs().maxCoeff());
  hessian = eigen.eigenvectors() * values.asDiagonal() * eigen.eigenvectors().transpose();
}

class Relaxation {
 public:
  Relaxation(const TriMesh& mesh, const std::vector<double>& vertex_weights, const StarHull& hull,
             const Points& start, const std::vector<bool>& fixed, const HullRelaxationOptions& options);

  HullRelaxation run();

 private:
  double distortion_energy(const Places& places) const;
  double energy(const Places& places) const;
  void add_pulls(Eigen::VectorXd& gradient, Eigen::SparseMatrix<double>& hessian) const;
  void measure_heights();
  Eigen::VectorXd newton_step();
  Places moved(const Eigen::VectorXd& step, double length) const;

  FacetDistortion distortion(std::size_t facet, const Places& places) const {
    const auto& [a, b, c] = facets_[facet];
    return {references_[facet], heights_[facet], places[a].position, places[b].position, places[c].position};
  }

  const Facets& facets_;
  const StarHull& hull_;
  const HullRelaxationOptions& options_;
  std::vector<ReferenceTriangle> references_;
  std::vector<double> facet_weights_;
  double total_weight_ = 0;
  std::vector<double> heights_;
  std::vector<int> unknowns_;  // per vertex, -1 when fixed
  int unknown_count_ = 0;
  Places places_;
  std::vector<Eigen::Matrix<double, 3, 2>> tangents_;
  FacetHessians assembly_;
  SparseCholesky solver_;
};

Relaxation::Relaxation(const TriMesh& mesh, const std::vector<double>& vertex_weights, const StarHull& hull,
                       const Points& start, const std::vector<bool>& fixed,
                       const HullRelaxationOptions& options)
    : facets_(mesh.facets()),
      hull_(hull),
      options_(options),
      references_(hull_references(mesh, hull.area())),
      heights_(mesh.facet_count()),
      unknowns_(numbered_unknowns(mesh.vertex_count(), fixed)),
      unknown_count_(1 + *std::max_element(unknowns_.begin(), unknowns_.end())),
      places_(hull.project(start)),
      tangents_(mesh.vertex_count()),
      assembly_(facets_, unknowns_) {
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    const auto& [a, b, c] = facets_[f];
    facet_weights_.push_back(std::min({vertex_weights[a], vertex_weights[b], vertex_weights[c]}));
    total_weight_ += facet_weights_.back() * references_[f].area;
  }
}

void Relaxation::measure_heights() {
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    double sum = 0;
    for (const int v : facets_[f]) sum += hull_.height(places_[v].facet);
    heights_[f] = sum / 3;
  }
}

double Relaxation::distortion_energy(const Places& places) const {
  double sum = 0;
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    sum += facet_weights_[f] * distortion(f, places).energy();
    if (!std::isfinite(sum)) return std::numeric_limits<double>::infinity();
  }
  return sum;
}

double Relaxation::energy(const Places& places) const {
  double sum = distortion_energy(places);
  for (const Pin& pull : options_.pulls) {
    sum += options_.pull_weight * (places[pull.vertex].position - pull.goal).squaredNorm();
  }
  return sum;
}

void Relaxation::add_pulls(Eigen::VectorXd& gradient, Eigen::SparseMatrix<double>& hessian) const {
  for (const Pin& pull : options_.pulls) {
    const int u = unknowns_[pull.vertex];
    if (u < 0) continue;
    gradient.segment<2>(2 * u) += 2 * options_.pull_weight * tangents_[pull.vertex].transpose() *
                                  (places_[pull.vertex].position - pull.goal);
    for (int i = 0; i < 2; ++i) hessian.coeffRef(2 * u + i, 2 * u + i) += 2 * options_.pull_weight;
  }
}

Eigen::VectorXd Relaxation::newton_step() {
  for (std::size_t v = 0; v < places_.size(); ++v) {
    const Vec3& normal = hull_.normal(places_[v].facet);
    tangents_[v].col(0) = normal.unitOrthogonal();
    tangents_[v].col(1) = normal.cross(tangents_[v].col(0));
  }
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(2 * unknown_count_);
  std::vector<LocalHessian> blocks(facets_.size());
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    const FacetDistortion facet = distortion(f, places_);
    Eigen::Matrix<double, 9, 6> tangent = Eigen::Matrix<double, 9, 6>::Zero();
    for (int i = 0; i < 3; ++i) tangent.block<3, 2>(3 * i, 2 * i) = tangents_[facets_[f][i]];
    const LocalGradient slope = facet_weights_[f] * (tangent.transpose() * facet.full_gradient());
    for (int i = 0; i < 3; ++i) {
      const int u = unknowns_[facets_[f][i]];
      if (u >= 0) gradient.segment<2>(2 * u) += slope.segment<2>(2 * i);
    }
    blocks[f] = facet_weights_[f] * (tangent.transpose() * facet.full_hessian() * tangent);
    make_positive(blocks[f]);
  }
  Eigen::SparseMatrix<double>& hessian = assembly_.assemble(blocks);
  add_pulls(gradient, hessian);
  if (!solver_.factorize(hessian)) {
    throw ComputationError("the distortion's Hessian is not positive definite in double precision");
  }
  return solver_.solve(-gradient);
}

Places Relaxation::moved(const Eigen::VectorXd& step, double length) const {
  Places places = places_;
  for (std::size_t v = 0; v < places.size(); ++v) {
    const int u = unknowns_[v];
    if (u < 0) continue;
    places[v] = hull_.project(places_[v].position + length * (tangents_[v] * step.segment<2>(2 * u)),
                              places_[v].facet);
  }
  return places;
}

HullRelaxation Relaxation::run() {
  HullRelaxation result;
  int small_decreases = 0;
  measure_heights();
  while (unknown_count_ > 0 && result.iterations < options_.most_iterations && small_decreases < 2) {
    const double before = energy(places_);
    if (!std::isfinite(before)) throw ComputationError("a facet of the start is not positively oriented");
    const Eigen::VectorXd step = newton_step();
    double after = before;
    for (double length = 1; length > 1e-6; length *= 0.6) {
      Places candidate = moved(step, length);
      after = energy(candidate);
      if (after < before) {
        places_ = std::move(candidate);
        break;
      }
    }
    ++result.iterations;
    if (!(after < before)) break;
    small_decreases = before - after < options_.least_decrease * before ? small_decreases + 1 : 0;
    measure_heights();
  }
  result.distortion = distortion_energy(places_) / (4 * total_weight_);
  for (const StarHull::Place& place : places_) result.images.push_back(place.position);
  return result;
}

}  // namespace

HullRelaxation relax_on_hull(const TriMesh& mesh, const std::vector<double>& vertex_weights,
                             const StarHull& hull, const Points& start, const std::vector<bool>& fixed,
                             const HullRelaxationOptions& options) {
  return Relaxation(mesh, vertex_weights, hull, start, fixed, options).run();
}

}  // namespace partwise
