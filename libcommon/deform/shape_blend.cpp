#include "deform/shape_blend.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "deform/aligned_model.h"
#include "deform/facet_transform.h"
#include "deform/rotation_logarithms.h"
#include "deform/smoothed_rotations.h"
#include "error.h"
#include "geometry/normals.h"
#include "mapping/parallel_parts.h"

namespace partwise {
namespace {

/// Over which rotations are smoothed, over the root of the model's area (which, unlike its bounding box, does
/// not change when it is turned): about the width of a limb.
constexpr double kReach = 0.08;
/// Up to this angle to its surroundings, in radians, a facet is not taken to have gone around once more.
constexpr double kCertain = 2;

/// The rotation of a model as a whole: nearest to the facets' rotations in the mean over area.
Eigen::Matrix3d whole_rotation(const std::vector<Eigen::Matrix3d>& rotations, const std::vector<bool>& known,
                               const std::vector<double>& areas) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (std::size_t f = 0; f < rotations.size(); ++f) {
    if (known[f]) sum += areas[f] * rotations[f];
  }
  return nearest_rotation(sum).value_or(Eigen::Matrix3d::Identity());
}

/// Extrapolated stretches may turn a facet inside out; here they end where it is a line.
Eigen::Matrix3d without_inversion(const Eigen::Matrix3d& stretch) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(stretch);
  if (solver.eigenvalues()[0] >= 0) return stretch;
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0).asDiagonal() *
         solver.eigenvectors().transpose();
}

/// The weights of rotations: those of weights that do not add up to 1 are of a blend that is scaled besides.
std::vector<double> shares_of(std::vector<double> weights) {
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  if (std::abs(sum) < 1e-9) return weights;
  for (double& weight : weights) weight /= sum;
  return weights;
}

}  // namespace

ShapeBlend::ShapeBlend(const TriMesh& first, const std::vector<Points>& others, BlendMethod method)
    : method_(method), facets_(first.facets()), models_{first.points()} {
  for (const Points& points : others) {
    if (points.size() != first.points().size()) {
      throw InputError("model " + std::to_string(models_.size()) + " has " + std::to_string(points.size()) +
                       " vertices, the first has " + std::to_string(first.vertex_count()));
    }
    models_.push_back(points);
  }
  if (method_ == BlendMethod::linear) return;
  split(first);
  integration_ = std::make_unique<SurfaceIntegration>(first, models_);
}

void ShapeBlend::split(const TriMesh& first) {
  facet_blends_.resize(facets_.size());
  whole_.assign(models_.size(), Vec3::Zero());
  const std::vector<double> areas = facet_areas(first.points(), facets_);
  for (std::size_t k = 1; k < models_.size(); ++k) {
    std::vector<Eigen::Matrix3d> rotations(facets_.size(), Eigen::Matrix3d::Identity());
    std::vector<bool> known(facets_.size(), false);
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      const auto transform = facet_transform(models_[0], models_[k], facets_[f]);
      known[f] = transform.has_value();
      rotations[f] = known[f] ? transform->rotation : Eigen::Matrix3d::Identity();
      facet_blends_[f].known = facet_blends_[f].known && known[f];
      facet_blends_[f].stretch.push_back(known[f] ? transform->stretch : Eigen::Matrix3d::Identity());
    }
    const Eigen::Matrix3d whole = whole_rotation(rotations, known, areas);
    whole_[k] = rotation_logarithm(whole);
    for (Eigen::Matrix3d& rotation : rotations) rotation = whole.transpose() * rotation;
    const std::vector<Eigen::Matrix3d> smooth = smoothed_rotations(
        first, rotations, known, kReach * std::sqrt(surface_area(first.points(), facets_)));
    const Points logarithms = rotation_logarithms(first, smooth, std::vector<bool>(facets_.size(), true));
    for (std::size_t f = 0; f < facets_.size(); ++f) rotations[f] = smooth[f].transpose() * rotations[f];
    const Points rest = rotation_logarithms(first, rotations, known, kCertain);
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      facet_blends_[f].smooth.push_back(logarithms[f]);
      facet_blends_[f].rest.push_back(rest[f]);
    }
  }
}

FacetEdges ShapeBlend::blended_edges(int facet, const std::vector<double>& weights,
                                     const std::vector<double>& shares, const Eigen::Matrix3d& whole) const {
  const FacetBlend& blend = facet_blends_[facet];
  FacetEdges edges = facet_edges(models_[0], facets_[facet]);
  if (!blend.known) {
    for (Vec3& edge : edges) edge *= weights[0];
    for (std::size_t k = 1; k < models_.size(); ++k) {
      const FacetEdges other = facet_edges(models_[k], facets_[facet]);
      for (int i = 0; i < 3; ++i) edges[i] += weights[k] * other[i];
    }
    return edges;
  }
  Vec3 smooth = Vec3::Zero(), rest = Vec3::Zero();
  Eigen::Matrix3d stretch = weights[0] * Eigen::Matrix3d::Identity();
  for (std::size_t k = 1; k < models_.size(); ++k) {
    smooth += shares[k] * blend.smooth[k - 1];
    rest += shares[k] * blend.rest[k - 1];
    stretch += weights[k] * blend.stretch[k - 1];
  }
  if (*std::min_element(weights.begin(), weights.end()) < 0) stretch = without_inversion(stretch);
  const Eigen::Matrix3d gradient =
      whole * rotation_exponential(smooth) * rotation_exponential(rest) * stretch;
  for (Vec3& edge : edges) edge = gradient * edge;
  return edges;
}

Points ShapeBlend::linear_frame(const std::vector<double>& weights) const {
  Points points(models_[0].size(), Vec3::Zero());
  for (std::size_t k = 0; k < models_.size(); ++k) {
    for (std::size_t v = 0; v < points.size(); ++v) points[v] += weights[k] * models_[k][v];
  }
  return points;
}

std::vector<Points> ShapeBlend::frames(const std::vector<std::vector<double>>& weights) const {
  for (const std::vector<double>& row : weights) {
    if (row.size() == models_.size()) continue;
    throw InputError(std::to_string(row.size()) + " weights for " + std::to_string(models_.size()) +
                     " models; give one for each");
  }
  const int count = static_cast<int>(weights.size());
  std::vector<Points> linear(count);
  for_each_part(count, [&](int i) { linear[i] = linear_frame(weights[i]); });
  if (method_ == BlendMethod::linear) return linear;
  std::vector<Points> centres(count);
  std::vector<Eigen::Matrix3d> whole(count);
  std::vector<std::vector<double>> shares;
  for (int i = 0; i < count; ++i) {
    shares.push_back(shares_of(weights[i]));
    centres[i] = integration_->centres(linear[i]);
    Vec3 logarithm = Vec3::Zero();
    for (std::size_t k = 1; k < models_.size(); ++k) logarithm += shares[i][k] * whole_[k];
    whole[i] = rotation_exponential(logarithm);
  }
  return integration_->integrate(
      [&](int frame, int facet) { return blended_edges(facet, weights[frame], shares[frame], whole[frame]); },
      centres);
}

std::vector<double> weights_at(int models, double place) {
  std::vector<double> weights(models, 0.0);
  const int from = std::clamp(static_cast<int>(std::floor(place)), 0, models - 2);
  weights[from] = 1 - (place - from);
  weights[from + 1] = place - from;
  return weights;
}

std::vector<std::vector<double>> weights_along(int models, int count) {
  std::vector<std::vector<double>> rows;
  rows.reserve(count);
  for (int i = 0; i < count; ++i) {
    rows.push_back(weights_at(models, count > 1 ? i * (models - 1.0) / (count - 1) : 0.0));
  }
  return rows;
}

}  // namespace partwise
