#include "segmentation/split_boundaries.h"

#include <Eigen/Core>

#include <algorithm>
#include <map>

#include "error.h"
#include "geometry/normals.h"

namespace partwise {
namespace {

/// Row v: every part's share of vertex v.
using Shares = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr double kLeastFraction = 0.2;

/// Shares by area of the facets around each vertex; all of a seeded vertex for its part.
Shares initial_shares(const TriMesh& mesh, const Seeds& seeds, const std::vector<int>& labels,
                      int part_count) {
  Shares shares = Shares::Zero(mesh.vertex_count(), part_count);
  const std::vector<double> areas = facet_areas(mesh.points(), mesh.facets());
  const std::vector<double> rings = ring_areas(mesh.points(), mesh.facets());
  for (int f = 0; f < mesh.facet_count(); ++f) {
    for (const int v : mesh.facet(f)) shares(v, labels[f]) += rings[v] > 0 ? areas[f] / rings[v] : 1;
  }
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (seeds.vertex_part[v] == kUnseeded) continue;
    shares.row(v).setZero();
    shares(v, seeds.vertex_part[v]) = 1;
  }
  return shares;
}

/// Half a vertex's own shares, half its neighbours' mean.
Shares averaged(const TriMesh& mesh, const Seeds& seeds, const Shares& shares) {
  Shares result = shares;
  Eigen::RowVectorXd mean(shares.cols());
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (seeds.vertex_part[v] != kUnseeded) continue;
    mean.setZero();
    int count = 0;
    for (const auto w : mesh.half_edges().vv_range(OpenMesh::VertexHandle(v))) {
      mean += shares.row(w.idx());
      ++count;
    }
    result.row(v) = 0.5 * shares.row(v) + 0.5 / count * mean;
  }
  return result;
}

std::vector<int> largest_shares(const Shares& shares) {
  std::vector<int> labels(shares.rows());
  for (Eigen::Index v = 0; v < shares.rows(); ++v) shares.row(v).maxCoeff(&labels[v]);
  return labels;
}

/// Every part must be one connected set of vertices.
void require_connected(const TriMesh& mesh, const std::vector<std::string>& names,
                       const std::vector<int>& labels) {
  std::vector<int> first(names.size(), -1);
  std::vector<bool> reached(labels.size(), false);
  for (int seed = 0; seed < mesh.vertex_count(); ++seed) {
    if (reached[seed]) continue;
    if (first[labels[seed]] >= 0) {
      throw ComputationError(
          "part '" + names[labels[seed]] + "' would fall apart near vertex " + std::to_string(seed) +
          ": it is too thin there to split edges along its boundary; leave --split-edges off, or "
          "draw its stroke through there");
    }
    first[labels[seed]] = seed;
    std::vector<int> stack{seed};
    reached[seed] = true;
    while (!stack.empty()) {
      const OpenMesh::VertexHandle v(stack.back());
      stack.pop_back();
      for (const auto w : mesh.half_edges().vv_range(v)) {
        if (reached[w.idx()] || labels[w.idx()] != labels[seed]) continue;
        reached[w.idx()] = true;
        stack.push_back(w.idx());
      }
    }
  }
  const auto missing = std::find(first.begin(), first.end(), -1);
  if (missing != first.end()) {
    throw ComputationError("part '" + names[missing - first.begin()] +
                           "' is too thin to split edges along its boundary; leave --split-edges off");
  }
}

class Splitting {
 public:
  Splitting(const TriMesh& mesh, const Shares& shares, std::vector<int> vertex_labels)
      : mesh_(mesh), shares_(shares), vertex_labels_(std::move(vertex_labels)), points_(mesh.points()) {}

  SplitMeshLabels run() &&;

 private:
  int crossing(int u, int v);
  void cut_corner(int p, int q, int r);
  void cut_in_three(const Facet& f);
  void add(const Facet& facet, int label) {
    facets_.push_back(facet);
    labels_.push_back(label);
  }

  const TriMesh& mesh_;
  const Shares& shares_;
  std::vector<int> vertex_labels_;
  Points points_;
  Facets facets_;
  std::vector<int> labels_;
  std::map<std::array<int, 2>, int> crossings_;
};

/// The vertex on edge (u, v) where the larger share passes from one part to the other.
int Splitting::crossing(int u, int v) {
  if (u > v) std::swap(u, v);
  const auto [entry, is_new] = crossings_.try_emplace({u, v}, static_cast<int>(points_.size()));
  if (is_new) {
    const int a = vertex_labels_[u], b = vertex_labels_[v];
    const double at_u = shares_(u, a) - shares_(u, b), at_v = shares_(v, b) - shares_(v, a);
    const double sum = at_u + at_v;
    const double t = std::clamp(sum > 0 ? at_u / sum : 0.5, kLeastFraction, 1 - kLeastFraction);
    points_.push_back((1 - t) * mesh_.point(u) + t * mesh_.point(v));
  }
  return entry->second;
}

/// Cuts corner p off the facet (p, q, r), whose other two vertices have the same part.
void Splitting::cut_corner(int p, int q, int r) {
  const int x = crossing(p, q), y = crossing(p, r);
  add({p, x, y}, vertex_labels_[p]);
  // The shorter diagonal of what is left.
  if ((points_[x] - points_[r]).squaredNorm() < (points_[q] - points_[y]).squaredNorm()) {
    add({x, q, r}, vertex_labels_[q]);
    add({x, r, y}, vertex_labels_[q]);
  } else {
    add({x, q, y}, vertex_labels_[q]);
    add({q, r, y}, vertex_labels_[q]);
  }
}

void Splitting::cut_in_three(const Facet& f) {
  std::array<int, 3> at{};  // on the edge from corner i to i + 1
  for (int i = 0; i < 3; ++i) at[i] = crossing(f[i], f[(i + 1) % 3]);
  const int centre = static_cast<int>(points_.size());
  points_.push_back((points_[at[0]] + points_[at[1]] + points_[at[2]]) / 3);
  for (int i = 0; i < 3; ++i) {
    add({f[i], at[i], centre}, vertex_labels_[f[i]]);
    add({f[i], centre, at[(i + 2) % 3]}, vertex_labels_[f[i]]);
  }
}

SplitMeshLabels Splitting::run() && {
  for (const Facet& f : mesh_.facets()) {
    const int a = vertex_labels_[f[0]], b = vertex_labels_[f[1]], c = vertex_labels_[f[2]];
    if (a == b && b == c)
      add(f, a);
    else if (b == c)
      cut_corner(f[0], f[1], f[2]);
    else if (c == a)
      cut_corner(f[1], f[2], f[0]);
    else if (a == b)
      cut_corner(f[2], f[0], f[1]);
    else
      cut_in_three(f);
  }
  const int added_vertices = static_cast<int>(points_.size()) - mesh_.vertex_count();
  const int added_facets = static_cast<int>(facets_.size()) - mesh_.facet_count();
  return {TriMesh(std::move(points_), std::move(facets_)), std::move(labels_), added_vertices, added_facets};
}

}  // namespace

SplitMeshLabels split_along_boundaries(const TriMesh& mesh, const std::vector<std::string>& names,
                                       const Seeds& seeds, const std::vector<int>& labels, int rounds) {
  Shares shares = initial_shares(mesh, seeds, labels, static_cast<int>(names.size()));
  for (int round = 0; round < rounds; ++round) shares = averaged(mesh, seeds, shares);
  std::vector<int> vertex_labels = largest_shares(shares);
  require_connected(mesh, names, vertex_labels);
  return Splitting(mesh, shares, std::move(vertex_labels)).run();
}

}  // namespace partwise
