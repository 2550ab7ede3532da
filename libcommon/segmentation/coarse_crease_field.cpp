#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>

#include "geometry/normals.h"
#include "segmentation/crease_field.h"
#include "segmentation/edge_bending.h"

namespace partwise {
namespace {

constexpr int kMostGroups = 60'000;

/// A symmetric 3 x 3 matrix: xx, xy, xz, yy, yz, zz.
using Tensor = Eigen::Array<double, 6, 1>;
using Tensors = std::vector<Tensor, Eigen::aligned_allocator<Tensor>>;

Tensor square(const Vec3& v) {
  return (Tensor() << v.x() * v.x(), v.x() * v.y(), v.x() * v.z(), v.y() * v.y(), v.y() * v.z(),
          v.z() * v.z())
      .finished();
}

/// u^T T u for a unit vector u.
double along(const Tensor& tensor, const Vec3& u) {
  const Tensor uu = square(u);
  return tensor[0] * uu[0] + tensor[3] * uu[3] + tensor[5] * uu[5] +
         2 * (tensor[1] * uu[1] + tensor[2] * uu[2] + tensor[4] * uu[4]);
}

/// Groups of facets: sums of bending (each edge half to either side) and area, and centroids.
struct Groups {
  Tensors bending;
  std::vector<double> area;
  Points centroid;
};

/// Per edge its dihedral angle over twice its length: the share in its bending of the facet on either side.
std::vector<double> half_bending(const TriMesh& mesh, const Points& normals) {
  std::vector<double> result(mesh.half_edges().n_edges());
  tbb::parallel_for(0, static_cast<int>(result.size()), [&](int e) {
    const double length = edge_length(mesh, e);
    result[e] = length > 0 ? dihedral_angle(mesh, normals, e) / length / 2 : 0;
  });
  return result;
}

/// Sums over groups go facet by facet, then edge by edge: rounding must not depend on the number of threads.
Groups bending_of_groups(const TriMesh& mesh, const std::vector<int>& group_of, int count) {
  Groups groups{Tensors(count, Tensor::Zero()), std::vector<double>(count, 0.0), Points(count, Vec3::Zero())};
  Points normals(mesh.facet_count());
  std::vector<double> areas(mesh.facet_count());
  tbb::parallel_for(0, mesh.facet_count(), [&](int f) {
    const auto& [a, b, c] = mesh.facet(f);
    const Vec3 vector = area_vector(mesh.point(a), mesh.point(b), mesh.point(c));
    areas[f] = vector.norm() / 2;
    normals[f] = vector.stableNormalized();
  });
  const auto add_facets = [&] {
    for (int f = 0; f < mesh.facet_count(); ++f) {
      const auto& [a, b, c] = mesh.facet(f);
      groups.area[group_of[f]] += areas[f];
      groups.centroid[group_of[f]] += areas[f] / 3 * (mesh.point(a) + mesh.point(b) + mesh.point(c));
    }
    for (int g = 0; g < count; ++g) {
      if (groups.area[g] > 0) groups.centroid[g] /= groups.area[g];
    }
  };
  const auto add_edges = [&] {
    const std::vector<double> bending = half_bending(mesh, normals);
    const HalfEdges& half_edges = mesh.half_edges();
    for (int e = 0; e < static_cast<int>(half_edges.n_edges()); ++e) {
      const auto h = half_edges.halfedge_handle(OpenMesh::EdgeHandle(e), 0);
      const OpenMesh::FaceHandle left = half_edges.face_handle(h), right = half_edges.opposite_face_handle(h);
      if (!left.is_valid() || !right.is_valid()) continue;
      const auto [from, to] = edge_ends(mesh, e);
      const Tensor bend = bending[e] * square(mesh.point(to) - mesh.point(from));
      groups.bending[group_of[left.idx()]] += bend;
      groups.bending[group_of[right.idx()]] += bend;
    }
  };
  tbb::parallel_invoke(add_facets, add_edges);
  return groups;
}

/// Curvature of every group: sums over the groups connected to it within a ball around its centroid.
Tensors curvature_of_groups(const Groups& groups, const FacetHierarchy::Level& level, double radius) {
  Tensors result(groups.area.size(), Tensor::Zero());
  tbb::parallel_for(tbb::blocked_range<int>(0, level.node_count(), 2048), [&](const auto& range) {
    std::vector<int> visited(groups.area.size(), -1), near;
    for (int g = range.begin(); g < range.end(); ++g) {
      Tensor sum = Tensor::Zero();
      double area = 0;
      near.assign(1, g);
      visited[g] = g;
      for (std::size_t i = 0; i < near.size(); ++i) {
        sum += groups.bending[near[i]];
        area += groups.area[near[i]];
        for (int k = level.first[near[i]]; k < level.first[near[i] + 1]; ++k) {
          const int other = level.neighbour[k];
          if (visited[other] == g) continue;
          visited[other] = g;
          if ((groups.centroid[other] - groups.centroid[g]).squaredNorm() <= radius * radius) {
            near.push_back(other);
          }
        }
      }
      // Sums over 1-rings, as in the exact field, count every edge twice and every facet thrice.
      if (area > 0) result[g] = 2 * sum / (3 * area);
    }
  });
  return result;
}

/// From a level to the one below: the parent's tensor, averaged with those of the neighbours' parents.
Tensors handed_down(const Tensors& above, const FacetHierarchy::Level& level) {
  Tensors result(level.node_count());
  tbb::parallel_for(0, level.node_count(), [&](int i) {
    Tensor sum = above[level.parent[i]];
    for (int k = level.first[i]; k < level.first[i + 1]; ++k) sum += above[level.parent[level.neighbour[k]]];
    result[i] = sum / (1 + level.first[i + 1] - level.first[i]);
  });
  return result;
}

}  // namespace

std::vector<double> edge_concavity(const TriMesh& mesh, const FacetHierarchy& hierarchy) {
  const auto& levels = hierarchy.levels();
  int top = 0;
  while (top + 1 < static_cast<int>(levels.size()) && levels[top].node_count() > kMostGroups) ++top;
  Tensors tensors;
  {
    const Groups groups = bending_of_groups(mesh, hierarchy.nodes_of_facets(top), levels[top].node_count());
    tensors = curvature_of_groups(groups, levels[top], kCreaseRadius * mesh.diagonal());
  }
  for (int k = top - 1; k >= 0; --k) tensors = handed_down(tensors, levels[k]);
  const double diagonal = mesh.diagonal();
  const HalfEdges& half_edges = mesh.half_edges();
  std::vector<double> concavity(half_edges.n_edges(), 0.0);
  tbb::parallel_for(0, static_cast<int>(concavity.size()), [&](int e) {
    const auto h = half_edges.halfedge_handle(OpenMesh::EdgeHandle(e), 0);
    const OpenMesh::FaceHandle left = half_edges.face_handle(h), right = half_edges.opposite_face_handle(h);
    if (!left.is_valid() || !right.is_valid()) return;
    const auto [from, to] = edge_ends(mesh, e);
    const Vec3 u = (mesh.point(to) - mesh.point(from)).stableNormalized();
    const Tensor both = tensors[left.idx()] + tensors[right.idx()];
    concavity[e] = std::max(0.0, -diagonal * along(both, u) / 2);
  });
  return concavity;
}

}  // namespace partwise
