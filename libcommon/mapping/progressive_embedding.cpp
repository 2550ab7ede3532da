#include "mapping/progressive_embedding.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>

#include "energy/symmetric_dirichlet.h"
#include "error.h"
#include "geometry/normals.h"
#include "mapping/collapse_to_tetrahedron.h"
#include "mesh/canonical_order.h"

namespace partwise {
namespace {

constexpr double kLeastQuality = 0.02;   // flatter reference facets count as equilateral
constexpr double kGrowthPerSweep = 1.6;  // all vertices are relaxed whenever their number grew by this factor
constexpr int kSweeps = 3;
constexpr double kEnoughRoom =
    1e-3;  // least distance of a new vertex to its ring's edges, over the ring's size
constexpr int kMostRetries = 12;

/// det(p, q, r) in the difference form, accurate for small facets.
double orientation(const Vec3& p, const Vec3& q, const Vec3& r) {
  return p.dot((q - p).cross(r - p));
}

/// Puts vertices on the sphere and moves them there, always with all facets positively oriented.
class Embedding {
 public:
  /// `names` are the vertices' numbers for people.
  Embedding(const TriMesh& mesh, const std::vector<double>& vertex_weights, const std::vector<int>& names,
            RingMesh& rings)
      : mesh_(mesh),
        weights_(vertex_weights),
        names_(names),
        rings_(rings),
        directions_(mesh.vertex_count(), Vec3::Zero()) {}

  void start_with_tetrahedron();
  void insert(const Collapse& collapse);
  void sweep(int count);
  Points directions() && { return std::move(directions_); }

 private:
  void measure_area();
  double room(const Vec3& candidate, const RingMesh::Ring& ring) const;
  Vec3 best_place(const RingMesh::Ring& ring, double size) const;
  double energy_around(int vertex, const Vec3& place) const;
  ReferenceTriangle reference(int u, int v, int w) const;
  void relax(int vertex);

  const TriMesh& mesh_;
  const std::vector<double>& weights_;
  const std::vector<int>& names_;
  RingMesh& rings_;
  Points directions_;
  double scale_ = 1;       // from lengths of the mesh to lengths on the sphere
  double least_area_ = 0;  // of reference facets, on the sphere
};

/// Scales the reference so that the current coarse mesh has the sphere's area.
void Embedding::measure_area() {
  double area = 0;
  for (int u = 0; u < mesh_.vertex_count(); ++u) {
    const RingMesh::Ring& ring = rings_.ring(u);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const int v = ring[i], w = ring[(i + 1) % ring.size()];
      if (u < v && u < w) area += area_vector(mesh_.point(u), mesh_.point(v), mesh_.point(w)).norm() / 2;
    }
  }
  constexpr double sphere = 4 * std::numbers::pi;
  if (area > 0) scale_ = std::sqrt(sphere / area);
  least_area_ = 1e-3 * sphere / (2.0 * rings_.present_count());
}

void Embedding::start_with_tetrahedron() {
  const double s = 1 / std::sqrt(3.0);
  const Points corners{{s, s, s}, {s, -s, -s}, {-s, s, -s}, {-s, -s, s}};
  int apex = 0;
  while (!rings_.is_present(apex)) ++apex;
  const RingMesh::Ring& ring = rings_.ring(apex);
  directions_[apex] = corners[0];
  for (int i = 0; i < 3; ++i) directions_[ring[i]] = corners[i + 1];
  if (orientation(directions_[apex], directions_[ring[0]], directions_[ring[1]]) < 0) {
    std::swap(directions_[ring[0]], directions_[ring[1]]);
  }
  measure_area();
}

/// Least distance of `candidate` to the planes through the centre and an edge of the ring: positive inside.
double Embedding::room(const Vec3& candidate, const RingMesh::Ring& ring) const {
  double least = 2;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec3& a = directions_[ring[i]];
    const Vec3& b = directions_[ring[(i + 1) % ring.size()]];
    least = std::min(least, orientation(candidate, a, b) / (a.cross(b).norm() + 1e-300));
  }
  return least;
}

/// The roomiest of some candidates: the ring's centroid, and places on the bisector of the wedge that opens
/// at the vertex the new one was merged into (any place near enough to its tip is inside).
Vec3 Embedding::best_place(const RingMesh::Ring& ring, double size) const {
  Vec3 centroid = Vec3::Zero();
  for (const int v : ring) centroid += directions_[v];
  Vec3 best = centroid.normalized();
  double most = room(best, ring);
  const Vec3& tip = directions_[ring[0]];
  const Vec3 inward = tip.cross(directions_[ring[1]]).stableNormalized() +
                      directions_[ring.back()].cross(tip).stableNormalized();
  double t = size;
  for (int k = 0; k < 45; ++k, t *= 0.6) {
    const Vec3 candidate = (tip + t * inward.stableNormalized()).normalized();
    const double found = room(candidate, ring);
    if (found > most) {
      most = found;
      best = candidate;
    }
  }
  return best;
}

void Embedding::insert(const Collapse& collapse) {
  const RingMesh::Ring& ring = collapse.ring;
  for (int retry = 0;; ++retry) {
    double size = 0;
    for (const int v : ring) size = std::max(size, (directions_[v] - directions_[ring[0]]).norm());
    const Vec3 place = best_place(ring, size);
    const double found = room(place, ring);
    if (found > kEnoughRoom * size || (retry == kMostRetries && found > 0)) {
      rings_.restore(collapse.vertex, ring);
      directions_[collapse.vertex] = place;
      break;
    }
    if (retry == kMostRetries) {
      throw ComputationError("no place on the sphere for vertex " + std::to_string(names_[collapse.vertex]) +
                             ": the facets around it are too small for double precision");
    }
    std::set<int> neighbourhood(ring.begin(), ring.end());
    for (const int v : ring) neighbourhood.insert(rings_.ring(v).begin(), rings_.ring(v).end());
    for (const int v : neighbourhood) relax(v);
  }
  relax(collapse.vertex);
  for (const int v : ring) relax(v);
}

ReferenceTriangle Embedding::reference(int u, int v, int w) const {
  return ReferenceTriangle::from(scale_ * mesh_.point(u), scale_ * mesh_.point(v), scale_ * mesh_.point(w),
                                 kLeastQuality, least_area_);
}

double Embedding::energy_around(int vertex, const Vec3& place) const {
  const RingMesh::Ring& ring = rings_.ring(vertex);
  double energy = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const int v = ring[i], w = ring[(i + 1) % ring.size()];
    const double weight = std::min({weights_[vertex], weights_[v], weights_[w]});
    energy +=
        weight * FacetDistortion(reference(vertex, v, w), 1, place, directions_[v], directions_[w]).energy();
  }
  return energy;
}

/// One Newton step of a vertex in its tangent plane, shortened until the energy falls; no facet turns over.
void Embedding::relax(int vertex) {
  const RingMesh::Ring& ring = rings_.ring(vertex);
  const Vec3 here = directions_[vertex];
  double energy = 0;
  Vec3 gradient = Vec3::Zero();
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const int v = ring[i], w = ring[(i + 1) % ring.size()];
    const double weight = std::min({weights_[vertex], weights_[v], weights_[w]});
    const FacetDistortion facet(reference(vertex, v, w), 1, here, directions_[v], directions_[w]);
    energy += weight * facet.energy();
    gradient += weight * facet.gradient();
    hessian += weight * facet.hessian();
  }
  Eigen::Matrix<double, 3, 2> tangent;
  tangent.col(0) = here.unitOrthogonal();
  tangent.col(1) = here.cross(tangent.col(0));
  const Eigen::Vector2d slope = tangent.transpose() * gradient;
  Eigen::Matrix2d curvature = tangent.transpose() * hessian * tangent;
  curvature.diagonal().array() -= here.dot(gradient);  // the sphere bends away from its tangent plane
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen;
  eigen.computeDirect(curvature);
  const Eigen::Vector2d values =
      eigen.eigenvalues().cwiseAbs().cwiseMax(1e-9 * eigen.eigenvalues().cwiseAbs().maxCoeff());
  if (!(values.minCoeff() > 0)) return;
  Eigen::Vector2d step =
      -eigen.eigenvectors() * (eigen.eigenvectors().transpose() * slope).cwiseQuotient(values);
  if (const double length = step.norm(); length > 0.5) step *= 0.5 / length;
  for (int k = 0; k < 12; ++k, step *= 0.5) {
    const Vec3 there = (here + tangent * step).normalized();
    if (energy_around(vertex, there) < energy) {
      directions_[vertex] = there;
      return;
    }
  }
}

void Embedding::sweep(int count) {
  measure_area();
  for (int k = 0; k < count; ++k) {
    for (int v = 0; v < mesh_.vertex_count(); ++v) {
      if (rings_.is_present(v)) relax(v);
    }
  }
}

void require_sphere(const TriMesh& mesh) {
  const HalfEdges& half_edges = mesh.half_edges();
  for (const auto h : half_edges.halfedges()) {
    if (half_edges.is_boundary(h)) throw InputError("the surface to embed is not closed");
  }
  if (const int euler = mesh.euler_characteristic(); euler != 2) {
    throw InputError("the surface to embed has Euler characteristic " + std::to_string(euler) +
                     ", not that of a sphere (2): cut it into parts without handles");
  }
}

}  // namespace

Points embed_progressively(const TriMesh& mesh, const std::vector<double>& vertex_weights) {
  require_sphere(mesh);
  // Which vertex comes first decides much of the result: the shape says so, not the numbering.
  const CanonicalOrder order = canonical_order(mesh);
  std::vector<double> weights;
  for (const int v : order.vertices) weights.push_back(vertex_weights[v]);
  RingMesh rings(order.mesh);
  std::vector<Collapse> record = collapse_to_tetrahedron(order.mesh, rings);
  Embedding embedding(order.mesh, weights, order.vertices, rings);
  embedding.start_with_tetrahedron();
  double next_sweep = 4 * kGrowthPerSweep;
  for (; !record.empty(); record.pop_back()) {
    embedding.insert(record.back());
    if (rings.present_count() >= next_sweep) {
      embedding.sweep(kSweeps);
      next_sweep = rings.present_count() * kGrowthPerSweep;
    }
  }
  embedding.sweep(kSweeps);
  const Points placed = std::move(embedding).directions();
  Points directions(placed.size());
  for (std::size_t i = 0; i < placed.size(); ++i) directions[order.vertices[i]] = placed[i];
  return directions;
}

}  // namespace partwise
