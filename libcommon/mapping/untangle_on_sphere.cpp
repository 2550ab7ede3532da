#include "mapping/untangle_on_sphere.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "energy/foldover_free.h"
#include "geometry/normals.h"

namespace partwise {
namespace {

constexpr int kRounds = 12;  // each reaches one ring farther around what is still folded
constexpr int kSweepsPerRound = 30;
constexpr int kScaleSmoothings = 8;
constexpr double kLeastQuality = 0.02;  // flatter reference facets count as equilateral

double orientation(const Vec3& a, const Vec3& b, const Vec3& c) {
  return a.dot((b - a).cross(c - a));
}

/// Per vertex: the logarithm of how much longer its surroundings are on the sphere than on the mesh.
std::vector<double> log_scales(const TriMesh& mesh, const Points& directions) {
  const int n = mesh.vertex_count();
  std::vector<double> here(n, 0.0), there(n, 0.0);
  for (const Facet& f : mesh.facets()) {
    const double area = area_vector(mesh.point(f[0]), mesh.point(f[1]), mesh.point(f[2])).norm();
    const double image = area_vector(directions[f[0]], directions[f[1]], directions[f[2]]).norm();
    for (const int v : f) {
      here[v] += area;
      there[v] += image;
    }
  }
  std::vector<double> scales(n, 0.0);
  for (int v = 0; v < n; ++v) {
    if (here[v] > 0 && there[v] > 0) scales[v] = std::log(there[v] / here[v]) / 2;
  }
  for (int i = 0; i < kScaleSmoothings; ++i) {
    const std::vector<double> before = scales;
    for (int v = 0; v < n; ++v) {
      double sum = 0;
      int count = 0;
      for (const auto w : mesh.half_edges().vv_range(OpenMesh::VertexHandle(v))) {
        sum += before[w.idx()];
        ++count;
      }
      if (count > 0) scales[v] = (before[v] + sum / count) / 2;
    }
  }
  return scales;
}

/// Per facet: its own shape, in the size of its surroundings on the sphere.
std::vector<ReferenceTriangle> sphere_references(const TriMesh& mesh, const Points& directions) {
  const std::vector<double> scales = log_scales(mesh, directions);
  const std::vector<double> areas = facet_areas(mesh.points(), mesh.facets());
  const double mean_area = std::accumulate(areas.begin(), areas.end(), 0.0) / mesh.facet_count();
  std::vector<ReferenceTriangle> references;
  references.reserve(areas.size());
  for (const Facet& f : mesh.facets()) {
    const double scale = std::exp((scales[f[0]] + scales[f[1]] + scales[f[2]]) / 3);
    references.push_back(ReferenceTriangle::from(scale * mesh.point(f[0]), scale * mesh.point(f[1]),
                                                 scale * mesh.point(f[2]), kLeastQuality,
                                                 0.01 * scale * scale * mean_area));
  }
  return references;
}

class SphereUntangling {
 public:
  SphereUntangling(const TriMesh& mesh, const Points& start, const std::vector<bool>& fixed)
      : mesh_(mesh), fixed_(fixed), directions_(start) {
    for (Vec3& direction : directions_) direction.stableNormalize();
    references_ = sphere_references(mesh, directions_);
  }

  UntangledDirections run();

 private:
  std::vector<int> folded_facets() const;
  std::vector<int> free_vertices_around(const std::vector<int>& facets, int rings) const;
  double least_ratio(const std::vector<int>& facets) const;
  FoldoverFree facet_at(int facet, int vertex, const Vec3& direction, double epsilon) const;
  double energy_at(int vertex, const Vec3& direction, double epsilon) const;
  void move(int vertex, double epsilon);

  const TriMesh& mesh_;
  const std::vector<bool>& fixed_;
  std::vector<ReferenceTriangle> references_;
  Points directions_;
};

std::vector<int> SphereUntangling::folded_facets() const {
  std::vector<int> folded;
  for (int f = 0; f < mesh_.facet_count(); ++f) {
    const auto& [a, b, c] = mesh_.facet(f);
    if (!(orientation(directions_[a], directions_[b], directions_[c]) > 0)) folded.push_back(f);
  }
  return folded;
}

std::vector<int> SphereUntangling::free_vertices_around(const std::vector<int>& facets, int rings) const {
  std::vector<int> found;
  std::vector<bool> seen(mesh_.vertex_count(), false);
  auto add = [&](int v) {
    if (!seen[v]) found.push_back(v);
    seen[v] = true;
  };
  for (const int f : facets) {
    for (const int v : mesh_.facet(f)) add(v);
  }
  for (std::size_t begin = 0; rings > 0; --rings) {
    for (const std::size_t end = found.size(); begin < end; ++begin) {
      for (const auto w : mesh_.half_edges().vv_range(OpenMesh::VertexHandle(found[begin]))) add(w.idx());
    }
  }
  std::erase_if(found, [&](int v) { return fixed_[v]; });
  std::sort(found.begin(), found.end());
  return found;
}

FoldoverFree SphereUntangling::facet_at(int facet, int vertex, const Vec3& direction, double epsilon) const {
  Facet corners = mesh_.facet(facet);
  ReferenceTriangle reference = references_[facet];
  while (corners[0] != vertex) {
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    reference.cotangents = Vec3(reference.cotangents[1], reference.cotangents[2], reference.cotangents[0]);
  }
  return {reference, 1, epsilon, direction, directions_[corners[1]], directions_[corners[2]]};
}

double SphereUntangling::energy_at(int vertex, const Vec3& direction, double epsilon) const {
  double sum = 0;
  for (const auto f : mesh_.half_edges().vf_range(OpenMesh::VertexHandle(vertex))) {
    sum += facet_at(f.idx(), vertex, direction, epsilon).energy();
  }
  return sum;
}

double SphereUntangling::least_ratio(const std::vector<int>& facets) const {
  double least = 1;
  for (const int f : facets) {
    const int v = mesh_.facet(f)[0];
    least = std::min(least, facet_at(f, v, directions_[v], 1).area_ratio());
  }
  return least;
}

void SphereUntangling::move(int vertex, double epsilon) {
  const Vec3 here = directions_[vertex];
  Vec3 gradient = Vec3::Zero();
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
  double before = 0;
  for (const auto f : mesh_.half_edges().vf_range(OpenMesh::VertexHandle(vertex))) {
    const FoldoverFree facet = facet_at(f.idx(), vertex, here, epsilon);
    gradient += facet.gradient();
    hessian += facet.hessian();
    before += facet.energy();
  }
  Eigen::Matrix<double, 3, 2> tangent;
  tangent.col(0) = here.unitOrthogonal();
  tangent.col(1) = here.cross(tangent.col(0));
  const Eigen::Matrix2d curvature = tangent.transpose() * hessian * tangent;
  Eigen::Vector2d step = -curvature.inverse() * (tangent.transpose() * gradient);
  if (!step.allFinite()) return;
  if (const double length = step.norm(); length > 0.5) step *= 0.5 / length;
  for (double length = 1; length > 1e-4; length *= 0.5) {
    const Vec3 there = (here + length * (tangent * step)).normalized();
    if (energy_at(vertex, there, epsilon) < before) {
      directions_[vertex] = there;
      return;
    }
  }
}

UntangledDirections SphereUntangling::run() {
  UntangledDirections result;
  std::vector<int> folded = folded_facets();
  result.folds_before = static_cast<int>(folded.size());
  Points best = directions_;
  std::size_t fewest = folded.size();
  for (int round = 0; round < kRounds && fewest > 0; ++round) {
    const std::vector<int> vertices = free_vertices_around(folded, 2 + round);
    for (int sweep = 0; sweep < kSweepsPerRound && !folded.empty(); ++sweep) {
      const double ratio = std::min(least_ratio(folded), 0.0);
      const double epsilon = std::sqrt(1e-9 + 0.04 * ratio * ratio);
      for (const int v : vertices) move(v, epsilon);
      folded = folded_facets();
      if (folded.size() < fewest) {
        fewest = folded.size();
        best = directions_;
      }
    }
  }
  result.folds_after = static_cast<int>(fewest);
  result.directions = std::move(best);
  return result;
}

}  // namespace

UntangledDirections untangle_on_sphere(const TriMesh& mesh, const Points& start,
                                       const std::vector<bool>& fixed) {
  return SphereUntangling(mesh, start, fixed).run();
}

}  // namespace partwise
