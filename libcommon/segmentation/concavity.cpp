#include "segmentation/concavity.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "error.h"
#include "geometry/convex_hull.h"

namespace partwise {
namespace {

/// Vertices of each part, ascending.
std::vector<std::vector<int>> part_vertices(const TriMesh& mesh, const std::vector<int>& labels,
                                            int part_count) {
  std::vector<int> first_part(mesh.vertex_count(), -1);
  std::vector<std::pair<int, int>> shared;  // vertex, a further part of it
  for (int f = 0; f < mesh.facet_count(); ++f) {
    const int part = labels[f];
    for (const int v : mesh.facet(f)) {
      if (first_part[v] < 0) first_part[v] = part;
      if (first_part[v] != part) shared.emplace_back(v, part);
    }
  }
  std::sort(shared.begin(), shared.end());
  shared.erase(std::unique(shared.begin(), shared.end()), shared.end());
  std::vector<std::vector<int>> vertices(part_count);
  auto further = shared.begin();
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (first_part[v] >= 0) vertices[first_part[v]].push_back(v);
    for (; further != shared.end() && further->first == v; ++further) vertices[further->second].push_back(v);
  }
  return vertices;
}

Concavity concavity_of(const TriMesh& mesh, const std::vector<int>& vertices) {
  if (vertices.empty()) return {};
  Points points;
  points.reserve(vertices.size());
  for (const int v : vertices) points.push_back(mesh.point(v));
  std::vector<double> distances;
  try {
    distances = distances_to_hull(convex_hull(points), points);
  } catch (const InputError&) {
    return {0, 0, vertices.front()};  // flat: there is no hull, and nothing to decompose
  }
  const auto largest = std::max_element(distances.begin(), distances.end());
  const double mean =
      std::accumulate(distances.begin(), distances.end(), 0.0) / static_cast<double>(distances.size());
  return {*largest / mesh.diagonal(), mean / mesh.diagonal(), vertices[largest - distances.begin()]};
}

}  // namespace

std::vector<Concavity> measure_concavity(const TriMesh& mesh, const std::vector<int>& labels,
                                         int part_count) {
  const auto vertices = part_vertices(mesh, labels, part_count);
  std::vector<Concavity> result(vertices.size());
  tbb::parallel_for(std::size_t{0}, vertices.size(),
                    [&](std::size_t part) { result[part] = concavity_of(mesh, vertices[part]); });
  return result;
}

}  // namespace partwise
