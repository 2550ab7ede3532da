#include "mapping/untangle.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

#include "energy/foldover_free.h"
#include "mesh/canonical_order.h"
#include "solve/facet_hessians.h"
#include "solve/sparse_cholesky.h"

namespace partwise {
namespace {

constexpr int kRounds = 12;  // each reaches one ring farther around what is still folded
constexpr int kSweepsPerRound = 30;
constexpr int kNewtonRounds = 4;  // reaching 4, 8, 16 ... rings
constexpr int kNewtonSteps = 30;
constexpr double kLongestStep = 0.5;  // of the surface's height

double orientation(const Vec3& a, const Vec3& b, const Vec3& c) {
  return a.dot((b - a).cross(c - a));
}

class Untangling {
 public:
  using Place = StarSurface::Place;

  Untangling(const TriMesh& mesh, const std::vector<ReferenceTriangle>& references,
             const StarSurface& surface, const Points& start, const std::vector<bool>& fixed)
      : mesh_(mesh), references_(references), surface_(surface), fixed_(fixed) {
    for (const Vec3& direction : start) places_.push_back(surface.project(direction));
  }

  UntangledMap run();

 private:
  std::vector<int> folded_facets() const;
  std::vector<int> free_vertices_around(int rings) const;
  double epsilon() const;
  FoldoverFree facet_at(int facet, int vertex, const Place& place, double epsilon) const;
  double energy_at(int vertex, const Place& place, double epsilon) const;
  void move(int vertex, double epsilon);
  void sweep(const std::vector<int>& vertices);
  struct Region;
  Region region(int rings) const;
  FoldoverFree facet_of(int facet, const std::vector<Place>& places, double epsilon) const;
  double energy_of(const Region& region, const std::vector<Place>& places, double epsilon) const;
  bool newton_step(Region& region);
  void rank_vertices();
  void keep_best();
  bool done() const { return fewest_ == 0; }

  Eigen::Matrix<double, 3, 2> tangent(int vertex) const {
    Eigen::Matrix<double, 3, 2> plane;
    plane.col(0) = places_[vertex].normal.unitOrthogonal();
    plane.col(1) = places_[vertex].normal.cross(plane.col(0));
    return plane;
  }

  const TriMesh& mesh_;
  const std::vector<ReferenceTriangle>& references_;
  const StarSurface& surface_;
  const std::vector<bool>& fixed_;
  std::vector<Place> places_, best_;
  std::vector<int> rank_;  // per vertex: when it moves in a sweep, by the shape and not by the numbering
  std::vector<int> folded_;
  std::size_t fewest_ = 0;
};

std::vector<int> Untangling::folded_facets() const {
  std::vector<int> folded;
  for (int f = 0; f < mesh_.facet_count(); ++f) {
    const auto& [a, b, c] = mesh_.facet(f);
    if (!(orientation(places_[a].position, places_[b].position, places_[c].position) > 0))
      folded.push_back(f);
  }
  return folded;
}

std::vector<int> Untangling::free_vertices_around(int rings) const {
  std::vector<int> found;
  std::vector<bool> seen(mesh_.vertex_count(), false);
  auto add = [&](int v) {
    if (!seen[v]) found.push_back(v);
    seen[v] = true;
  };
  for (const int f : folded_) {
    for (const int v : mesh_.facet(f)) add(v);
  }
  for (std::size_t begin = 0; rings > 0; --rings) {
    for (const std::size_t end = found.size(); begin < end; ++begin) {
      for (const auto w : mesh_.half_edges().vv_range(OpenMesh::VertexHandle(found[begin]))) add(w.idx());
    }
  }
  std::erase_if(found, [&](int v) { return !fixed_.empty() && fixed_[v]; });
  std::sort(found.begin(), found.end(), [&](int v, int w) { return rank_[v] < rank_[w]; });
  return found;
}

FoldoverFree Untangling::facet_at(int facet, int vertex, const Place& place, double epsilon) const {
  Facet corners = mesh_.facet(facet);
  ReferenceTriangle reference = references_[facet];
  while (corners[0] != vertex) {
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    reference.cotangents = Vec3(reference.cotangents[1], reference.cotangents[2], reference.cotangents[0]);
  }
  const Place &next = places_[corners[1]], &last = places_[corners[2]];
  // The heights of the places before the move: with those after it, the energy would have them to
  // differentiate.
  const double height = (places_[vertex].height + next.height + last.height) / 3;
  return {reference, height, epsilon, place.position, next.position, last.position};
}

double Untangling::energy_at(int vertex, const Place& place, double epsilon) const {
  double sum = 0;
  for (const auto f : mesh_.half_edges().vf_range(OpenMesh::VertexHandle(vertex))) {
    sum += facet_at(f.idx(), vertex, place, epsilon).energy();
  }
  return sum;
}

/// How much the energy is regularised: as the worst fold asks for.
double Untangling::epsilon() const {
  double least = 0;
  for (const int f : folded_) {
    const int v = mesh_.facet(f)[0];
    least = std::min(least, facet_at(f, v, places_[v], 1).area_ratio());
  }
  return std::sqrt(1e-9 + 0.04 * least * least);
}

void Untangling::move(int vertex, double epsilon) {
  const Place here = places_[vertex];
  Vec3 gradient = Vec3::Zero();
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
  double before = 0;
  for (const auto f : mesh_.half_edges().vf_range(OpenMesh::VertexHandle(vertex))) {
    const FoldoverFree facet = facet_at(f.idx(), vertex, here, epsilon);
    gradient += facet.gradient();
    hessian += facet.hessian();
    before += facet.energy();
  }
  const Eigen::Matrix<double, 3, 2> plane = tangent(vertex);
  const Eigen::Matrix2d curvature = plane.transpose() * hessian * plane;
  Eigen::Vector2d step = -curvature.inverse() * (plane.transpose() * gradient);
  if (!step.allFinite()) return;
  const double longest = kLongestStep * here.height;
  if (const double length = step.norm(); length > longest) step *= longest / length;
  for (double length = 1; length > 1e-4; length *= 0.5) {
    const Place there = surface_.project(here.position + length * (plane * step));
    if (energy_at(vertex, there, epsilon) < before) {
      places_[vertex] = there;
      return;
    }
  }
}

void Untangling::sweep(const std::vector<int>& vertices) {
  const double regularisation = epsilon();
  for (const int v : vertices) move(v, regularisation);
}

/// The facets around some vertices, and what Newton's method needs to move these together.
struct Untangling::Region {
  std::vector<int> vertices;
  std::vector<int> facet_numbers;
  std::vector<int> unknowns;  // per vertex of the mesh, -1 outside
  FacetHessians assembly;
  SparseCholesky solver;
};

Untangling::Region Untangling::region(int rings) const {
  std::vector<int> vertices = free_vertices_around(rings);
  std::vector<int> unknowns(mesh_.vertex_count(), -1);
  for (std::size_t i = 0; i < vertices.size(); ++i) unknowns[vertices[i]] = static_cast<int>(i);
  std::vector<int> numbers;
  Facets facets;
  for (int f = 0; f < mesh_.facet_count(); ++f) {
    const Facet& facet = mesh_.facet(f);
    if (std::none_of(facet.begin(), facet.end(), [&](int v) { return unknowns[v] >= 0; })) continue;
    numbers.push_back(f);
    facets.push_back(facet);
  }
  FacetHessians assembly(facets, unknowns);
  return {std::move(vertices), std::move(numbers), std::move(unknowns), std::move(assembly),
          SparseCholesky()};
}

double Untangling::energy_of(const Region& region, const std::vector<Place>& places, double epsilon) const {
  double sum = 0;
  for (const int f : region.facet_numbers) sum += facet_of(f, places, epsilon).energy();
  return sum;
}

FoldoverFree Untangling::facet_of(int facet, const std::vector<Place>& places, double epsilon) const {
  const auto& [a, b, c] = mesh_.facet(facet);
  const double height = (places_[a].height + places_[b].height + places_[c].height) / 3;
  return {references_[facet], height, epsilon, places[a].position, places[b].position, places[c].position};
}

/// Moves the region's vertices together, without folding more. \return false when that lowers the energy no
/// more
bool Untangling::newton_step(Region& region) {
  const double regularisation = epsilon();
  Eigen::VectorXd downhill = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(region.vertices.size()));
  std::vector<FacetHessians::Block> blocks;
  blocks.reserve(region.facet_numbers.size());
  for (const int f : region.facet_numbers) {
    const FoldoverFree facet = facet_of(f, places_, regularisation);
    Eigen::Matrix<double, 9, 6> planes = Eigen::Matrix<double, 9, 6>::Zero();
    for (int i = 0; i < 3; ++i) planes.block<3, 2>(3 * i, 2 * i) = tangent(mesh_.facet(f)[i]);
    const Eigen::Matrix<double, 6, 1> slope = planes.transpose() * facet.full_gradient();
    blocks.push_back(planes.transpose() * facet.full_hessian() * planes);
    blocks.back().diagonal() *= 1 + 1e-9;
    for (int i = 0; i < 3; ++i) {
      const int u = region.unknowns[mesh_.facet(f)[i]];
      if (u >= 0) downhill.segment<2>(2 * u) -= slope.segment<2>(2 * i);
    }
  }
  if (!region.solver.factorize(region.assembly.assemble(blocks))) return false;
  Eigen::VectorXd step = region.solver.solve(downhill);
  for (std::size_t i = 0; i < region.vertices.size(); ++i) {
    auto move = step.segment<2>(static_cast<Eigen::Index>(2 * i));
    const double longest = kLongestStep * places_[region.vertices[i]].height;
    if (const double length = move.norm(); length > longest) step *= longest / length;
  }
  const double before = energy_of(region, places_, regularisation);
  std::vector<Place> places = places_;
  for (double length = 1; length > 1e-5; length *= 0.5) {
    for (std::size_t i = 0; i < region.vertices.size(); ++i) {
      const int v = region.vertices[i];
      const auto at = static_cast<Eigen::Index>(2 * i);
      places[v] = surface_.project(places_[v].position + length * (tangent(v) * step.segment<2>(at)));
    }
    if (!(energy_of(region, places, regularisation) < before)) continue;
    int folds = 0;
    for (const int f : region.facet_numbers) folds += facet_of(f, places, 1).area_ratio() > 0 ? 0 : 1;
    if (folds > static_cast<int>(folded_.size())) continue;
    places_ = std::move(places);
    return true;
  }
  return false;
}

void Untangling::rank_vertices() {
  const CanonicalOrder order = canonical_order(mesh_);
  rank_.resize(order.vertices.size());
  for (std::size_t i = 0; i < order.vertices.size(); ++i) rank_[order.vertices[i]] = static_cast<int>(i);
}

void Untangling::keep_best() {
  folded_ = folded_facets();
  if (folded_.size() >= fewest_) return;
  fewest_ = folded_.size();
  best_ = places_;
}

UntangledMap Untangling::run() {
  UntangledMap result;
  const std::vector<Place> start = places_;
  folded_ = folded_facets();
  result.folds_before = static_cast<int>(folded_.size());
  fewest_ = folded_.size();
  best_ = places_;
  if (!done()) rank_vertices();
  for (int round = 0; round < kRounds && !done(); ++round) {
    const std::vector<int> vertices = free_vertices_around(2 + round);
    for (int i = 0; i < kSweepsPerRound && !done(); ++i) {
      sweep(vertices);
      keep_best();
    }
  }
  for (int round = 0; round < kNewtonRounds && !done(); ++round) {
    places_ = best_;
    folded_ = folded_facets();
    Region all = region(4 << round);
    for (int i = 0; i < kNewtonSteps && !done() && newton_step(all); ++i) {
      keep_best();
    }
  }
  result.folds_after = static_cast<int>(fewest_);
  for (std::size_t v = 0; v < best_.size(); ++v) {
    result.images.push_back(best_[v].position);
    result.moved.push_back(best_[v].position != start[v].position);
  }
  return result;
}

}  // namespace

UntangledMap untangle(const TriMesh& mesh, const std::vector<ReferenceTriangle>& references,
                      const StarSurface& surface, const Points& start, const std::vector<bool>& fixed) {
  return Untangling(mesh, references, surface, start, fixed).run();
}

}  // namespace partwise
