#include "mapping/relax_on_hull.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "energy/symmetric_dirichlet.h"
#include "error.h"
#include "geometry/normals.h"
#include "mapping/hull_references.h"
#include "mapping/smooth_hull.h"
#include "solve/facet_hessians.h"
#include "solve/sparse_cholesky.h"

namespace partwise {
namespace {

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

double facet_weight(const Facet& facet, const std::vector<double>& vertex_weights) {
  return std::min({vertex_weights[facet[0]], vertex_weights[facet[1]], vertex_weights[facet[2]]});
}

class Relaxation {
 public:
  Relaxation(const TriMesh& mesh, const std::vector<double>& vertex_weights, const StarHull& hull,
             const Points& start, const std::vector<bool>& fixed, double rounding,
             const HullRelaxationOptions& options);

  HullRelaxation run();

 private:
  using Places = std::vector<SmoothHull::Place>;

  double distortion_energy(const Places& places) const;
  double energy(const Places& places) const;
  void measure_surface();
  LocalHessian facet_hessian(std::size_t facet, Points& gradient) const;
  void add_pulls(Points& gradient, Eigen::SparseMatrix<double>& hessian) const;
  void add_bends(const Points& gradient, Eigen::SparseMatrix<double>& hessian) const;
  Eigen::VectorXd newton_step();
  Places moved(const Eigen::VectorXd& step, double length) const;

  FacetDistortion distortion(std::size_t facet, const Places& places) const {
    const SmoothHull::Place &a = places[facets_[facet][0]], &b = places[facets_[facet][1]],
                            &c = places[facets_[facet][2]];
    return {references_[facet], (a.height + b.height + c.height) / 3, a.position, b.position, c.position};
  }

  const Facets& facets_;
  const StarHull& hull_;
  const SmoothHull smooth_;
  const HullRelaxationOptions& options_;
  std::vector<ReferenceTriangle> references_;
  std::vector<double> facet_weights_;
  std::vector<int> unknowns_;  // per vertex, -1 when fixed
  int unknown_count_ = 0;
  std::vector<Pin> pulls_;
  Places places_;
  // Of the surface at each vertex's place.
  std::vector<SmoothHull::Gauge> gauges_;
  Points height_gradients_;
  std::vector<Eigen::Matrix<double, 3, 2>> tangents_;
  FacetHessians assembly_;
  SparseCholesky solver_;
};

Relaxation::Relaxation(const TriMesh& mesh, const std::vector<double>& vertex_weights, const StarHull& hull,
                       const Points& start, const std::vector<bool>& fixed, double rounding,
                       const HullRelaxationOptions& options)
    : facets_(mesh.facets()),
      hull_(hull),
      smooth_(hull, rounding),
      options_(options),
      references_(hull_references(mesh, hull.area())),
      unknowns_(numbered_unknowns(mesh.vertex_count(), fixed)),
      unknown_count_(1 + *std::max_element(unknowns_.begin(), unknowns_.end())),
      pulls_(options.pulls),
      gauges_(mesh.vertex_count()),
      height_gradients_(mesh.vertex_count()),
      tangents_(mesh.vertex_count()),
      assembly_(facets_, unknowns_) {
  for (const Vec3& direction : start) places_.push_back(smooth_.project(direction));
  for (Pin& pull : pulls_) pull.goal = smooth_.project(pull.goal).position;
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    facet_weights_.push_back(facet_weight(facets_[f], vertex_weights));
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
  for (const Pin& pull : pulls_) {
    sum += options_.pull_weight * (places[pull.vertex].position - pull.goal).squaredNorm();
  }
  return sum;
}

void Relaxation::measure_surface() {
  for (std::size_t v = 0; v < places_.size(); ++v) {
    gauges_[v] = smooth_.gauge(places_[v].position);
    const double steepness = gauges_[v].gradient.norm();
    const Vec3 normal = gauges_[v].gradient / steepness;
    height_gradients_[v] = normal - gauges_[v].hessian * normal / (steepness * steepness);
    tangents_[v].col(0) = normal.unitOrthogonal();
    tangents_[v].col(1) = normal.cross(tangents_[v].col(0));
  }
}

/// A facet's part of the Hessian, without the heights' second derivatives; adds its part of the gradient.
LocalHessian Relaxation::facet_hessian(std::size_t f, Points& gradient) const {
  const FacetDistortion facet = distortion(f, places_);
  const Eigen::Matrix<double, 9, 1> slope = facet.full_gradient();
  double heights = 0;
  for (const int v : facets_[f]) heights += places_[v].height;
  Eigen::Matrix<double, 9, 6> tangent = Eigen::Matrix<double, 9, 6>::Zero();
  Eigen::Matrix<double, 9, 1> log_height;
  for (int i = 0; i < 3; ++i) {
    const int v = facets_[f][i];
    tangent.block<3, 2>(3 * i, 2 * i) = tangents_[v];
    log_height.segment<3>(3 * i) = height_gradients_[v] / heights;
    gradient[v] += facet_weights_[f] *
                   (slope.segment<3>(3 * i) + facet.log_height_slope() * log_height.segment<3>(3 * i));
  }
  const Eigen::Matrix<double, 9, 9> mixed = facet.log_height_slope_gradient() * log_height.transpose();
  const Eigen::Matrix<double, 9, 9> full = facet.full_hessian() + mixed + mixed.transpose() +
                                           2 * facet.log_height_slope() * log_height * log_height.transpose();
  LocalHessian block = facet_weights_[f] * (tangent.transpose() * full * tangent);
  make_positive(block);
  return block;
}

void Relaxation::add_pulls(Points& gradient, Eigen::SparseMatrix<double>& hessian) const {
  for (const Pin& pull : pulls_) {
    gradient[pull.vertex] += 2 * options_.pull_weight * (places_[pull.vertex].position - pull.goal);
    const int u = unknowns_[pull.vertex];
    if (u < 0) continue;
    for (int i = 0; i < 2; ++i) hessian.coeffRef(2 * u + i, 2 * u + i) += 2 * options_.pull_weight;
  }
}

/// Moving a vertex by t along its tangent plane and back to the surface, p + t -> (p + t) / g(p + t), adds
/// the surface's own bend: the gradient's part along p times the Hessian of the gauge g.
void Relaxation::add_bends(const Points& gradient, Eigen::SparseMatrix<double>& hessian) const {
  for (std::size_t v = 0; v < places_.size(); ++v) {
    const int u = unknowns_[v];
    const double inward = -gradient[v].dot(places_[v].position);
    if (u < 0 || inward <= 0) continue;
    const Eigen::Matrix2d bend = inward * tangents_[v].transpose() * gauges_[v].hessian * tangents_[v];
    hessian.coeffRef(2 * u, 2 * u) += bend(0, 0);
    hessian.coeffRef(2 * u + 1, 2 * u) += bend(1, 0);
    hessian.coeffRef(2 * u + 1, 2 * u + 1) += bend(1, 1);
  }
}

/// Newton's step in the tangent planes, two entries per unknown.
Eigen::VectorXd Relaxation::newton_step() {
  measure_surface();
  Points gradient(places_.size(), Vec3::Zero());
  std::vector<LocalHessian> blocks(facets_.size());
  for (std::size_t f = 0; f < facets_.size(); ++f) blocks[f] = facet_hessian(f, gradient);
  Eigen::SparseMatrix<double>& hessian = assembly_.assemble(blocks);
  add_pulls(gradient, hessian);
  add_bends(gradient, hessian);
  Eigen::VectorXd downhill(2 * unknown_count_);
  for (std::size_t v = 0; v < places_.size(); ++v) {
    if (unknowns_[v] >= 0) downhill.segment<2>(2 * unknowns_[v]) = -tangents_[v].transpose() * gradient[v];
  }
  // Where facets differ by many orders of magnitude, sums of positive blocks are positive only up to
  // rounding.
  for (double lift = 0; !solver_.factorize(hessian); lift = std::max(1e-10, 10 * lift)) {
    if (lift > 1e-4) {
      throw ComputationError("the distortion's Hessian is not positive definite in double precision");
    }
    hessian.diagonal() *= 1 + std::max(1e-10, 10 * lift);
  }
  return solver_.solve(downhill);
}

Relaxation::Places Relaxation::moved(const Eigen::VectorXd& step, double length) const {
  Places places = places_;
  for (std::size_t v = 0; v < places.size(); ++v) {
    const int u = unknowns_[v];
    if (u < 0) continue;
    places[v] = smooth_.project(places_[v].position + length * (tangents_[v] * step.segment<2>(2 * u)));
  }
  return places;
}

HullRelaxation Relaxation::run() {
  HullRelaxation result;
  int small_decreases = 0;
  double before = energy(places_);
  if (!std::isfinite(before)) throw ComputationError("a facet of the start is not positively oriented");
  while (unknown_count_ > 0 && result.iterations < options_.most_iterations && small_decreases < 2) {
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
    before = after;
  }
  Points directions;
  for (const SmoothHull::Place& place : places_) directions.push_back(place.position);
  for (const StarHull::Place& place : hull_.project(directions)) result.images.push_back(place.position);
  return result;
}

}  // namespace

double hull_distortion(const TriMesh& mesh, const std::vector<double>& vertex_weights, const StarHull& hull,
                       const Points& images) {
  const std::vector<ReferenceTriangle> references = hull_references(mesh, hull.area());
  double sum = 0, total = 0;
  for (int f = 0; f < mesh.facet_count(); ++f) {
    const auto& [a, b, c] = mesh.facet(f);
    const double weight = facet_weight(mesh.facet(f), vertex_weights);
    const double height = area_vector(images[a], images[b], images[c]).normalized().dot(images[a]);
    sum += weight * FacetDistortion(references[f], height, images[a], images[b], images[c]).energy();
    total += weight * references[f].area;
  }
  return std::isfinite(sum) ? sum / (4 * total) : std::numeric_limits<double>::infinity();
}

HullRelaxation relax_on_hull(const TriMesh& mesh, const std::vector<double>& vertex_weights,
                             const StarHull& hull, const Points& start, const std::vector<bool>& fixed,
                             const HullRelaxationOptions& options) {
  HullRelaxation result;
  result.images = start;
  for (const double rounding : options.rounding) {
    const int before = result.iterations;
    result = Relaxation(mesh, vertex_weights, hull, result.images, fixed, rounding, options).run();
    result.iterations += before;
  }
  result.distortion = hull_distortion(mesh, vertex_weights, hull, result.images);
  return result;
}

}  // namespace partwise
