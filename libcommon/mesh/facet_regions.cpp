#include "mesh/facet_regions.h"

#include <algorithm>
#include <numeric>

namespace partwise {
namespace {

/// The root of a tree, and all on the way nearer to it.
int root_of(std::vector<int>& parent, int f) {
  while (parent[f] != f) {
    parent[f] = parent[parent[f]];
    f = parent[f];
  }
  return f;
}

}  // namespace

// Trees joined in the order of the facets read memory nearly in order, which a flood from a facet does not.
std::vector<int> facet_regions(const TriMesh& mesh, const std::vector<int>& labels) {
  const HalfEdges& half_edges = mesh.half_edges();
  std::vector<int> parent(mesh.facet_count());
  std::iota(parent.begin(), parent.end(), 0);
  for (int f = 0; f < mesh.facet_count(); ++f) {
    OpenMesh::HalfedgeHandle h = half_edges.halfedge_handle(OpenMesh::FaceHandle(f));
    for (int side = 0; side < 3; ++side, h = half_edges.next_halfedge_handle(h)) {
      const int other = half_edges.opposite_face_handle(h).idx();
      if (other < 0 || other > f || (!labels.empty() && labels[other] != labels[f])) continue;
      const int a = root_of(parent, f), b = root_of(parent, other);
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  for (int& p : parent) p = parent[p];  // smaller facets lead straight to their roots already
  return parent;
}

}  // namespace partwise
