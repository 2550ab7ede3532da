#include "mapping/untangle_on_hull.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

#include "energy/foldover_free.h"
#include "mapping/hull_references.h"

namespace partwise {
namespace {

constexpr int kRounds = 12;  // each reaches one ring farther around what is still folded
constexpr int kSweepsPerRound = 30;

class Untangling {
 public:
  Untangling(const TriMesh& mesh, const StarHull& hull, const Points& start, const std::vector<bool>& fixed);

  UntangledMap run();

 private:
  std::vector<int> folded_facets() const;
  std::vector<int> free_vertices_around(const std::vector<int>& facets, int rings) const;
  double least_ratio(const std::vector<int>& facets) const;
  void move(int vertex, double epsilon);

  /// Sum over the facets at `vertex`; places it at `position` first.
  double energy_at(int vertex, const Vec3& position, double epsilon) const;
  FoldoverFree facet_at(int facet, int vertex, const Vec3& position, double epsilon) const;

  const TriMesh& mesh_;
  const StarHull& hull_;
  const std::vector<bool>& fixed_;
  std::vector<ReferenceTriangle> references_;
  std::vector<StarHull::Place> places_;
};

Untangling::Untangling(const TriMesh& mesh, const StarHull& hull, const Points& start,
                       const std::vector<bool>& fixed)
    : mesh_(mesh),
      hull_(hull),
      fixed_(fixed),
      references_(hull_references(mesh, hull.area())),
      places_(hull.project(start)) {}

std::vector<int> Untangling::folded_facets() const {
  std::vector<int> folded;
  for (int f = 0; f < mesh_.facet_count(); ++f) {
    const auto& [a, b, c] = mesh_.facet(f);
    const Vec3& p = places_[a].position;
    if (!(p.dot((places_[b].position - p).cross(places_[c].position - p)) > 0)) folded.push_back(f);
  }
  return folded;
}

std::vector<int> Untangling::free_vertices_around(const std::vector<int>& facets, int rings) const {
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
    const std::size_t end = found.size();
    for (; begin < end; ++begin) {
      for (const auto w : mesh_.half_edges().vv_range(OpenMesh::VertexHandle(found[begin]))) add(w.idx());
    }
  }
  std::erase_if(found, [&](int v) { return !fixed_.empty() && fixed_[v]; });
  std::sort(found.begin(), found.end());
  return found;
}

FoldoverFree Untangling::facet_at(int facet, int vertex, const Vec3& position, double epsilon) const {
  Facet corners = mesh_.facet(facet);
  ReferenceTriangle reference = references_[facet];
  while (corners[0] != vertex) {
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    reference.cotangents = Vec3(reference.cotangents[1], reference.cotangents[2], reference.cotangents[0]);
  }
  const double height = (hull_.height(places_[corners[0]].facet) + hull_.height(places_[corners[1]].facet) +
                         hull_.height(places_[corners[2]].facet)) /
                        3;
  return {reference, height, epsilon, position, places_[corners[1]].position, places_[corners[2]].position};
}

double Untangling::energy_at(int vertex, const Vec3& position, double epsilon) const {
  double sum = 0;
  for (const auto f : mesh_.half_edges().vf_range(OpenMesh::VertexHandle(vertex))) {
    sum += facet_at(f.idx(), vertex, position, epsilon).energy();
  }
  return sum;
}

double Untangling::least_ratio(const std::vector<int>& facets) const {
  double least = 1;
  for (const int f : facets) {
    const int v = mesh_.facet(f)[0];
    least = std::min(least, facet_at(f, v, places_[v].position, 1).area_ratio());
  }
  return least;
}

void Untangling::move(int vertex, double epsilon) {
  const StarHull::Place here = places_[vertex];
  Vec3 gradient = Vec3::Zero();
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
  for (const auto f : mesh_.half_edges().vf_range(OpenMesh::VertexHandle(vertex))) {
    const FoldoverFree facet = facet_at(f.idx(), vertex, here.position, epsilon);
    gradient += facet.gradient();
    hessian += facet.hessian();
  }
  Eigen::Matrix<double, 3, 2> tangent;
  const Vec3& normal = hull_.normal(here.facet);
  tangent.col(0) = normal.unitOrthogonal();
  tangent.col(1) = normal.cross(tangent.col(0));
  const Eigen::Matrix2d curvature = tangent.transpose() * hessian * tangent;
  const Eigen::Vector2d step = -curvature.inverse() * (tangent.transpose() * gradient);
  if (!step.allFinite()) return;
  const double before = energy_at(vertex, here.position, epsilon);
  for (double length = 1; length > 1e-4; length *= 0.5) {
    const StarHull::Place there = hull_.project(here.position + length * (tangent * step), here.facet);
    if (energy_at(vertex, there.position, epsilon) < before) {
      places_[vertex] = there;
      return;
    }
  }
}

UntangledMap Untangling::run() {
  UntangledMap result;
  std::vector<int> folded = folded_facets();
  result.folds_before = static_cast<int>(folded.size());
  std::vector<StarHull::Place> best = places_;
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
        best = places_;
      }
    }
  }
  result.folds_after = static_cast<int>(fewest);
  for (const StarHull::Place& place : best) result.images.push_back(place.position);
  return result;
}

}  // namespace

UntangledMap untangle_on_hull(const TriMesh& mesh, const StarHull& hull, const Points& start,
                              const std::vector<bool>& fixed) {
  return Untangling(mesh, hull, start, fixed).run();
}

}  // namespace partwise
