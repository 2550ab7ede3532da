#include "remeshing/unfold.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "energy/foldover_free.h"
#include "energy/symmetric_dirichlet.h"
#include "geometry/normals.h"
#include "mesh/vertex_rings.h"

namespace partwise {
namespace {

/// The energy of a vertex's ring as a function of its place, the other vertices at rest. `scales` as in
/// `relax`.
class RingEnergy {
 public:
  RingEnergy(const MeshOnSurface& mesh, int vertex, double epsilon, const std::vector<double>& scales)
      : mesh_(mesh), epsilon_(epsilon) {
    double source_area = 0, area = 0, size = 0, wanted = 0;
    const Points& rest = mesh.source().points();
    for (const int f : mesh.ring(vertex)) {
      const Facet& facet = mesh.source().facet(f);
      const int first = static_cast<int>(std::find(facet.begin(), facet.end(), vertex) - facet.begin());
      const int b = facet[(first + 1) % 3], c = facet[(first + 2) % 3];
      corners_.push_back({vertex, b, c});
      if (!scales.empty()) wanted += scales[f];
      const Points& p = mesh.points();
      source_area += area_vector(rest[vertex], rest[b], rest[c]).norm() / 2;
      area += area_vector(p[vertex], p[b], p[c]).norm() / 2;
      size = std::max({size, (p[b] - p[vertex]).norm(), (p[c] - p[vertex]).norm()});
      normals_.push_back((mesh.normal(vertex) + mesh.normal(b) + mesh.normal(c)).stableNormalized());
    }
    is_valid_ = source_area > 0 && area > 0;
    if (!is_valid_) return;
    const double scale =
        scales.empty() ? std::sqrt(area / source_area) : wanted / static_cast<double>(corners_.size());
    const double least_area = 1e-3 * scale * scale * source_area / static_cast<double>(corners_.size());
    for (const Facet& f : corners_) {
      references_.push_back(ReferenceTriangle::from(scale * rest[f[0]], scale * rest[f[1]],
                                                    scale * rest[f[2]], 0.02, least_area));
    }
    // A plane is the surface of a ball so large that its curvature is lost.
    height_ = 1e5 * size;
  }

  bool is_valid() const { return is_valid_; }

  double at(const Vec3& place) const {
    double sum = 0;
    for (std::size_t i = 0; i < corners_.size(); ++i) sum += facet(i, place).energy();
    return sum;
  }

  /// Newton's step in the plane across `normal`.
  Vec3 step(const Vec3& place, const Vec3& normal) const {
    Vec3 gradient = Vec3::Zero();
    Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const FoldoverFree energy = facet(i, place);
      gradient += energy.gradient();
      hessian += energy.hessian();
    }
    Eigen::Matrix<double, 3, 2> plane;
    plane.col(0) = normal.unitOrthogonal();
    plane.col(1) = normal.cross(plane.col(0));
    const Eigen::Matrix2d flat = plane.transpose() * hessian * plane;
    if (!(flat.determinant() > 0)) return Vec3::Zero();
    return -plane * (flat.inverse() * (plane.transpose() * gradient));
  }

 private:
  FoldoverFree facet(std::size_t i, const Vec3& place) const {
    const Vec3 lift = height_ * normals_[i] - place;
    return FoldoverFree(references_[i], height_, epsilon_, height_ * normals_[i],
                        mesh_.points()[corners_[i][1]] + lift, mesh_.points()[corners_[i][2]] + lift);
  }

  const MeshOnSurface& mesh_;
  double epsilon_;
  double height_ = 1;
  bool is_valid_ = false;
  Facets corners_;
  Points normals_;
  std::vector<ReferenceTriangle> references_;
};

/// One step of one vertex; halved until it lowers the energy and flips nothing.
void improve(MeshOnSurface& mesh, int vertex, double epsilon, const std::vector<double>& scales = {}) {
  if (mesh.is_pinned(vertex) || mesh.normal(vertex).isZero(0)) return;
  const RingEnergy energy(mesh, vertex, epsilon, scales);
  if (!energy.is_valid()) return;
  const Vec3 start = mesh.points()[vertex];
  const SurfacePoint old = mesh.image(vertex);
  const double before = energy.at(start);
  const int flipped = mesh.flipped_around(vertex);
  Vec3 step = energy.step(start, mesh.normal(vertex));
  constexpr int halvings = 6;
  for (int i = 0; i < halvings && !step.isZero(0); ++i, step /= 2) {
    const SurfacePoint next = mesh.walker().towards(old, start + step);
    if (energy.at(position(mesh.target(), next)) >= before || !mesh.allows(vertex, next)) continue;
    mesh.place(vertex, next);
    if (mesh.flipped_around(vertex) <= flipped) return;
    mesh.place(vertex, old);
  }
}

/// Vertices within `rings` of a flipped facet, ascending.
std::vector<int> around_flipped(const MeshOnSurface& mesh, int rings) {
  std::vector<bool> near(mesh.points().size(), false);
  for (int f = 0; f < mesh.source().facet_count(); ++f) {
    if (mesh.quality(f) >= 0) continue;
    for (const int v : mesh.source().facet(f)) near[v] = true;
  }
  near = within_rings(mesh.source().facets(), std::move(near), rings - 1);
  std::vector<int> vertices;
  for (std::size_t v = 0; v < near.size(); ++v) {
    if (near[v]) vertices.push_back(static_cast<int>(v));
  }
  return vertices;
}

}  // namespace

int unfold(MeshOnSurface& mesh, const UnfoldOptions& options) {
  for (int i = 0; i < options.sweeps; ++i) {
    const std::vector<int> vertices = around_flipped(mesh, options.rings + i / 20);
    if (vertices.empty()) return 0;
    for (const int v : vertices) improve(mesh, v, 0.1);
  }
  return mesh.flipped_count();
}

void relax(MeshOnSurface& mesh, int sweeps, const std::vector<double>& scales) {
  for (int i = 0; i < sweeps; ++i) {
    for (int v = 0; v < mesh.source().vertex_count(); ++v) improve(mesh, v, 1e-2, scales);
  }
}

}  // namespace partwise
