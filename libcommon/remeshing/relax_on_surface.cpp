#include "remeshing/relax_on_surface.h"

#include <algorithm>

#include "energy/foldover_free.h"
#include "geometry/normals.h"
#include "solve/facet_hessians.h"
#include "solve/sparse_cholesky.h"

namespace partwise {
namespace {

constexpr double kEpsilon = 1e-2;       // of the regularisation
constexpr double kLeastQuality = 0.02;  // flatter reference facets count as equilateral
constexpr int kHalvings = 5;            // of a vertex's own step, when the whole would fold

// Vertices cut short by the chart may let the energy rise for a step or two before it falls on.
constexpr int kPatience = 5;

using Tangents = std::vector<Eigen::Matrix<double, 3, 2>>;

/// In which planes vertices step: across the target's normals at their images, which a long step follows
/// around bends, or in the facets that these lie in, where a short step does just what the gradient says.
enum class StepPlanes { across_normals, of_facets };

class Relaxation {
 public:
  Relaxation(MeshOnSurface& mesh, const std::vector<double>& scales, double least_quality,
             const std::vector<PlacePull>& pulls);

  double energy(const Points& points) const;
  double area() const { return area_; }

  /// One Newton step; false when it does not lower the energy.
  bool step() { return step(StepPlanes::across_normals) || step(StepPlanes::of_facets); }

 private:
  bool step(StepPlanes planes);
  Tangents tangents(StepPlanes planes) const;
  FoldoverFree facet(std::size_t f, const Points& points) const;
  Vec3 offset(const PlacePull& pull, const Points& points) const;
  Eigen::VectorXd newton_direction(const Tangents& tangents);
  std::vector<SurfacePoint> moved(const Points& steps, double length) const;
  Points positions(const std::vector<SurfacePoint>& images) const;
  void commit(const std::vector<SurfacePoint>& images);
  void measure_normals();

  MeshOnSurface& mesh_;
  double least_quality_;
  const std::vector<PlacePull>& pulls_;
  const Facets& facets_;
  std::vector<ReferenceTriangle> references_;
  Points normals_;  // per facet: the target's at its image, unit
  double height_;
  double area_ = 0;
  std::vector<int> unknowns_;
  FacetHessians assembly_;
  SparseCholesky solver_;
};

std::vector<bool> pinned(const MeshOnSurface& mesh) {
  std::vector<bool> result;
  for (int v = 0; v < mesh.source().vertex_count(); ++v) {
    result.push_back(mesh.is_pinned(v) || mesh.normal(v).isZero(0));
  }
  return result;
}

Relaxation::Relaxation(MeshOnSurface& mesh, const std::vector<double>& scales, double least_quality,
                       const std::vector<PlacePull>& pulls)
    : mesh_(mesh),
      least_quality_(least_quality),
      pulls_(pulls),
      facets_(mesh.source().facets()),
      // A plane is the surface of a ball so large that its curvature is lost.
      height_(1e5 * mesh.target().diagonal()),
      unknowns_(numbered_unknowns(mesh.source().vertex_count(), pinned(mesh))),
      assembly_(facets_, unknowns_) {
  const std::vector<double> areas = facet_areas(mesh.source().points(), facets_);
  double sum = 0;
  for (std::size_t f = 0; f < facets_.size(); ++f) sum += scales[f] * scales[f] * areas[f];
  const Points& rest = mesh.source().points();
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    const auto& [a, b, c] = facets_[f];
    references_.push_back(ReferenceTriangle::from(scales[f] * rest[a], scales[f] * rest[b],
                                                  scales[f] * rest[c], kLeastQuality,
                                                  1e-3 * sum / static_cast<double>(facets_.size())));
    area_ += references_.back().area;
  }
  measure_normals();
}

void Relaxation::measure_normals() {
  normals_.clear();
  for (const auto& [a, b, c] : facets_) {
    normals_.push_back((mesh_.normal(a) + mesh_.normal(b) + mesh_.normal(c)).stableNormalized());
  }
}

FoldoverFree Relaxation::facet(std::size_t f, const Points& points) const {
  const auto& [a, b, c] = facets_[f];
  const Vec3 lift = height_ * normals_[f] - points[a];
  return {references_[f], height_, kEpsilon, height_ * normals_[f], points[b] + lift, points[c] + lift};
}

Vec3 Relaxation::offset(const PlacePull& pull, const Points& points) const {
  const auto& [a, b, c] = facets_[pull.place.facet];
  const Vec3& shares = pull.place.barycentric;
  return shares[0] * points[a] + shares[1] * points[b] + shares[2] * points[c] - pull.target;
}

double Relaxation::energy(const Points& points) const {
  double sum = 0;
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    if (!normals_[f].isZero(0)) sum += facet(f, points).energy();
  }
  for (const PlacePull& pull : pulls_) sum += pull.weight * offset(pull, points).squaredNorm();
  return sum;
}

Eigen::VectorXd Relaxation::newton_direction(const Tangents& tangents) {
  const int count = 1 + *std::max_element(unknowns_.begin(), unknowns_.end());
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(2 * count);
  std::vector<FacetHessians::Block> blocks(facets_.size(), FacetHessians::Block::Zero());
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    if (normals_[f].isZero(0)) continue;
    const FoldoverFree energy = facet(f, mesh_.points());
    Eigen::Matrix<double, 9, 6> tangent = Eigen::Matrix<double, 9, 6>::Zero();
    for (int i = 0; i < 3; ++i) tangent.block<3, 2>(3 * i, 2 * i) = tangents[facets_[f][i]];
    const Eigen::Matrix<double, 6, 1> slope = tangent.transpose() * energy.full_gradient();
    for (int i = 0; i < 3; ++i) {
      const int u = unknowns_[facets_[f][i]];
      if (u >= 0) gradient.segment<2>(2 * u) += slope.segment<2>(2 * i);
    }
    blocks[f] = tangent.transpose() * energy.full_hessian() * tangent;
  }
  for (const PlacePull& pull : pulls_) {
    const Facet& corners = facets_[pull.place.facet];
    const Vec3& shares = pull.place.barycentric;
    const Vec3 slope = 2 * pull.weight * offset(pull, mesh_.points());
    for (int i = 0; i < 3; ++i) {
      const Eigen::Matrix<double, 2, 3> across = shares[i] * tangents[corners[i]].transpose();
      const int u = unknowns_[corners[i]];
      if (u >= 0) gradient.segment<2>(2 * u) += across * slope;
      for (int j = 0; j < 3; ++j) {
        blocks[pull.place.facet].block<2, 2>(2 * i, 2 * j) +=
            2 * pull.weight * shares[j] * across * tangents[corners[j]];
      }
    }
  }
  Eigen::SparseMatrix<double>& hessian = assembly_.assemble(blocks);
  // A facet may move as a whole without changing its energy; a mesh without pinned vertices, too.
  const double lift = 1e-9 * hessian.diagonal().cwiseAbs().maxCoeff();
  for (int i = 0; i < hessian.rows(); ++i) hessian.coeffRef(i, i) += lift;
  if (!solver_.factorize(hessian)) return {};
  return solver_.solve(-gradient);
}

std::vector<SurfacePoint> Relaxation::moved(const Points& steps, double length) const {
  std::vector<SurfacePoint> images = mesh_.images();
  for (std::size_t v = 0; v < steps.size(); ++v) {
    if (unknowns_[v] < 0) continue;
    images[v] = mesh_.walker().towards(images[v], mesh_.points()[v] + length * steps[v]);
  }
  return images;
}

Points Relaxation::positions(const std::vector<SurfacePoint>& images) const {
  Points points;
  points.reserve(images.size());
  for (const SurfacePoint& image : images) points.push_back(position(mesh_.target(), image));
  return points;
}

/// Places the vertices one after the other, each as far as it may go.
void Relaxation::commit(const std::vector<SurfacePoint>& images) {
  for (int v = 0; v < mesh_.source().vertex_count(); ++v) {
    if (unknowns_[v] < 0) continue;
    const SurfacePoint old = mesh_.image(v);
    const Vec3 from = mesh_.points()[v];
    SurfacePoint next = images[v];
    Vec3 step = position(mesh_.target(), next) - from;
    for (int i = 0; i < kHalvings; ++i) {
      if (mesh_.move_to(v, next, least_quality_)) break;
      step /= 2;
      next = mesh_.walker().towards(old, from + step);
    }
  }
}

Tangents Relaxation::tangents(StepPlanes planes) const {
  Tangents result(mesh_.points().size());
  for (std::size_t v = 0; v < result.size(); ++v) {
    if (unknowns_[v] < 0) continue;
    const int vertex = static_cast<int>(v);
    Vec3 normal = Vec3::Zero();
    if (planes == StepPlanes::of_facets) {
      const auto& [a, b, c] = mesh_.target().facet(mesh_.image(vertex).facet);
      const Points& points = mesh_.target().points();
      normal = (points[b] - points[a]).cross(points[c] - points[a]).stableNormalized();
    }
    if (normal.isZero(0)) normal = mesh_.normal(vertex);
    result[v].col(0) = normal.unitOrthogonal();
    result[v].col(1) = normal.cross(result[v].col(0));
  }
  return result;
}

bool Relaxation::step(StepPlanes planes) {
  const Tangents along = tangents(planes);
  const Eigen::VectorXd direction = newton_direction(along);
  if (direction.size() == 0) return false;
  Points steps(along.size(), Vec3::Zero());
  for (std::size_t v = 0; v < steps.size(); ++v) {
    if (unknowns_[v] >= 0) steps[v] = along[v] * direction.segment<2>(2 * unknowns_[v]);
  }
  const double before = energy(mesh_.points());
  for (double length = 1; length > 0.02; length *= 0.5) {
    const std::vector<SurfacePoint> images = moved(steps, length);
    if (energy(positions(images)) >= before) continue;
    commit(images);
    measure_normals();
    return true;
  }
  return false;
}

}  // namespace

SurfaceRelaxation relax_on_surface(MeshOnSurface& mesh, const std::vector<double>& scales,
                                   const SurfaceRelaxationOptions& options,
                                   const std::vector<PlacePull>& pulls) {
  SurfaceRelaxation result;
  Relaxation relaxation(mesh, scales, options.least_quality, pulls);
  result.energy_before = result.energy_after = relaxation.energy(mesh.points()) / relaxation.area();
  int small_decreases = 0;
  while (result.iterations < options.iterations && small_decreases < kPatience) {
    if (!relaxation.step()) break;
    ++result.iterations;
    const double energy = relaxation.energy(mesh.points()) / relaxation.area();
    small_decreases =
        result.energy_after - energy < options.least_decrease * energy ? small_decreases + 1 : 0;
    result.energy_after = energy;
  }
  return result;
}

}  // namespace partwise
