#include "segmentation/crease_field.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "geometry/normals.h"
#include "segmentation/edge_bending.h"

namespace partwise {
namespace {

using OpenMesh::VertexHandle;
using Tensor = Eigen::Matrix3d;

constexpr double kCrease = 20;  // concavity at which an edge counts as a crease

/// Curvature tensor times area, and area, of the 1-ring of every vertex.
struct VertexBending {
  std::vector<Tensor, Eigen::aligned_allocator<Tensor>> tensor;
  std::vector<double> area;
};

VertexBending bending_of_rings(const TriMesh& mesh) {
  VertexBending bending{{static_cast<std::size_t>(mesh.vertex_count()), Tensor::Zero()},
                        std::vector<double>(mesh.vertex_count(), 0.0)};
  const std::vector<double> areas = facet_areas(mesh.points(), mesh.facets());
  for (int f = 0; f < mesh.facet_count(); ++f) {
    for (const int v : mesh.facet(f)) bending.area[v] += areas[f];
  }
  const Points normals = facet_normals(mesh.points(), mesh.facets());
  for (int e = 0; e < static_cast<int>(mesh.half_edges().n_edges()); ++e) {
    const auto [from, to] = edge_ends(mesh, e);
    const Vec3 edge = mesh.point(to) - mesh.point(from);
    const double length = edge.norm();
    if (length == 0) continue;
    const Tensor bend = dihedral_angle(mesh, normals, e) / length * edge * edge.transpose();
    bending.tensor[from] += bend;
    bending.tensor[to] += bend;
  }
  return bending;
}

/// Neighbours of all vertices in one array: far quicker to walk than half-edges.
struct Adjacency {
  explicit Adjacency(const TriMesh& mesh) : first(1, 0) {
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      for (const VertexHandle w : mesh.half_edges().vv_range(VertexHandle(v))) neighbours.push_back(w.idx());
      first.push_back(static_cast<int>(neighbours.size()));
    }
  }
  std::vector<int> first;
  std::vector<int> neighbours;
};

/// Vertices connected to `centre` within the ball of `radius` around it, by breadth.
class Neighbourhood {
 public:
  Neighbourhood(const Points& points, const Adjacency& adjacency)
      : points_(points), adjacency_(adjacency), visited_(points.size(), -1) {}

  const std::vector<int>& around(int centre, double radius) {
    vertices_.assign(1, centre);
    visited_[centre] = centre;
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      const int v = vertices_[i];
      for (int k = adjacency_.first[v]; k < adjacency_.first[v + 1]; ++k) {
        const int w = adjacency_.neighbours[k];
        if (visited_[w] == centre) continue;
        visited_[w] = centre;
        if ((points_[w] - points_[centre]).squaredNorm() <= radius * radius) vertices_.push_back(w);
      }
    }
    return vertices_;
  }

 private:
  const Points& points_;
  const Adjacency& adjacency_;
  std::vector<int> visited_;
  std::vector<int> vertices_;
};

std::vector<Tensor, Eigen::aligned_allocator<Tensor>> curvature_tensors(const TriMesh& mesh) {
  const VertexBending bending = bending_of_rings(mesh);
  const double radius = kCreaseRadius * mesh.diagonal();
  const Adjacency adjacency(mesh);
  std::vector<Tensor, Eigen::aligned_allocator<Tensor>> result(mesh.vertex_count());
  tbb::parallel_for(tbb::blocked_range<int>(0, mesh.vertex_count(), 2048), [&](const auto& range) {
    Neighbourhood neighbourhood(mesh.points(), adjacency);
    for (int v = range.begin(); v < range.end(); ++v) {
      Tensor sum = Tensor::Zero();
      double area = 0;
      for (const int near : neighbourhood.around(v, radius)) {
        sum += bending.tensor[near];
        area += bending.area[near];
      }
      result[v] = area > 0 ? Tensor(sum / area) : Tensor::Zero();
    }
  });
  return result;
}

}  // namespace

double edge_length(const TriMesh& mesh, int index) {
  const auto [from, to] = edge_ends(mesh, index);
  return (mesh.point(to) - mesh.point(from)).norm();
}

double mean_edge_length(const TriMesh& mesh) {
  const int count = static_cast<int>(mesh.half_edges().n_edges());
  double sum = 0;
  for (int e = 0; e < count; ++e) sum += edge_length(mesh, e);
  return sum / count;
}

std::vector<double> edge_concavity(const TriMesh& mesh) {
  const auto tensors = curvature_tensors(mesh);
  const double diagonal = mesh.diagonal();
  std::vector<double> concavity(mesh.half_edges().n_edges(), 0.0);
  tbb::parallel_for(0, static_cast<int>(concavity.size()), [&](int e) {
    const auto [from, to] = edge_ends(mesh, e);
    const Vec3 u = (mesh.point(to) - mesh.point(from)).stableNormalized();
    concavity[e] = std::max(0.0, -diagonal * u.dot((tensors[from] + tensors[to]) * u) / 2);
  });
  return concavity;
}

std::vector<double> boundary_costs(const TriMesh& mesh, const std::vector<double>& concavity) {
  const double h = mean_edge_length(mesh);
  std::vector<double> costs(concavity.size());
  tbb::parallel_for(0, static_cast<int>(costs.size()), [&](int e) {
    const double crease = concavity[e] / kCrease;
    costs[e] = edge_length(mesh, e) / h * (0.1 + 0.9 / (1 + crease * crease));
  });
  return costs;
}

}  // namespace partwise
