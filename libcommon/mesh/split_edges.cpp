#include "mesh/split_edges.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "error.h"

namespace partwise {
namespace {

using Edge = std::array<int, 2>;

/// A convex polygon whose corners may lie on its sides: side[i] is the straight line that the edge from
/// vertex[i] to the next one belongs to.
struct Polygon {
  std::vector<int> vertex;
  std::vector<int> side;

  std::size_t size() const { return vertex.size(); }
  std::size_t next(std::size_t i) const { return (i + 1) % size(); }
  std::size_t previous(std::size_t i) const { return (i + size() - 1) % size(); }
};

/// Whether the fan around a vertex has facets with area only: no edge that it does not end lies on one of its
/// own sides.
bool can_fan(const Polygon& polygon, std::size_t apex) {
  const int left = polygon.side[apex], right = polygon.side[polygon.previous(apex)];
  for (std::size_t i = polygon.next(apex); polygon.next(i) != apex; i = polygon.next(i)) {
    if (polygon.side[i] == left || polygon.side[i] == right) return false;
  }
  return true;
}

/// Whether cutting off a corner leaves a polygon with area.
bool can_cut_off(const Polygon& polygon, std::size_t corner) {
  const std::size_t previous = polygon.previous(corner);
  if (polygon.side[corner] == polygon.side[previous]) return false;
  std::set<int> sides;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (i != corner && i != previous) sides.insert(polygon.side[i]);
  }
  return sides.size() >= 2;
}

void triangulate(Polygon polygon, Facets& facets) {
  for (int new_side = 3; polygon.size() > 3; ++new_side) {
    std::vector<std::size_t> order(polygon.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return polygon.vertex[i] > polygon.vertex[j]; });
    const auto apex =
        std::find_if(order.begin(), order.end(), [&](std::size_t i) { return can_fan(polygon, i); });
    if (apex != order.end()) {
      for (std::size_t i = polygon.next(*apex); polygon.next(i) != *apex; i = polygon.next(i)) {
        facets.push_back({polygon.vertex[*apex], polygon.vertex[i], polygon.vertex[polygon.next(i)]});
      }
      return;
    }
    const std::size_t corner =
        *std::find_if(order.begin(), order.end(), [&](std::size_t i) { return can_cut_off(polygon, i); });
    const std::size_t previous = polygon.previous(corner);
    facets.push_back(
        {polygon.vertex[previous], polygon.vertex[corner], polygon.vertex[polygon.next(corner)]});
    polygon.side[previous] = new_side;
    polygon.vertex.erase(polygon.vertex.begin() + static_cast<std::ptrdiff_t>(corner));
    polygon.side.erase(polygon.side.begin() + static_cast<std::ptrdiff_t>(corner));
  }
  facets.push_back({polygon.vertex[0], polygon.vertex[1], polygon.vertex[2]});
}

/// Per edge (smaller vertex first): fraction from there and number of the vertex added.
using AddedVertices = std::map<Edge, std::vector<std::pair<double, int>>>;

AddedVertices sorted_by_edge(const TriMesh& mesh, const std::vector<EdgePoint>& points) {
  AddedVertices added;
  const HalfEdges& half_edges = mesh.half_edges();
  const int n = mesh.vertex_count();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [a, b, fraction] = points[i];
    const bool known = std::min(a, b) >= 0 && std::max(a, b) < n && a != b;
    const bool is_edge =
        known && half_edges.find_halfedge(OpenMesh::VertexHandle(a), OpenMesh::VertexHandle(b)).is_valid();
    if (!is_edge || !(fraction > 0 && fraction < 1)) {
      throw InputError("point " + std::to_string(i) + ", " + std::to_string(fraction) +
                       " of the way between vertices " + std::to_string(a) + " and " + std::to_string(b) +
                       ", is no point inside an edge");
    }
    auto& on_edge = added[{std::min(a, b), std::max(a, b)}];
    on_edge.emplace_back(a < b ? fraction : 1 - fraction, n + static_cast<int>(i));
  }
  for (auto& [edge, on_edge] : added) {
    std::sort(on_edge.begin(), on_edge.end());
    for (std::size_t i = 1; i < on_edge.size(); ++i) {
      if (on_edge[i - 1].first < on_edge[i].first) continue;
      throw InputError("points " + std::to_string(on_edge[i - 1].second - n) + " and " +
                       std::to_string(on_edge[i].second - n) + " are the same point of an edge");
    }
  }
  return added;
}

Polygon polygon_of(const Facet& facet, const AddedVertices& added) {
  Polygon polygon;
  auto add = [&](int vertex, int side) {
    polygon.vertex.push_back(vertex);
    polygon.side.push_back(side);
  };
  for (int i = 0; i < 3; ++i) {
    const int a = facet[i], b = facet[(i + 1) % 3];
    add(a, i);
    const auto found = added.find({std::min(a, b), std::max(a, b)});
    if (found == added.end()) continue;
    const auto& on_edge = found->second;
    for (std::size_t j = 0; j < on_edge.size(); ++j) {
      add(on_edge[a < b ? j : on_edge.size() - 1 - j].second, i);
    }
  }
  return polygon;
}

}  // namespace

EdgeSplitMesh split_edges(const TriMesh& mesh, const std::vector<EdgePoint>& points) {
  if (points.empty()) {
    std::vector<int> parents(mesh.facet_count());
    for (int f = 0; f < mesh.facet_count(); ++f) parents[f] = f;
    return {mesh, std::move(parents), {}};
  }
  const AddedVertices added = sorted_by_edge(mesh, points);
  Points positions = mesh.points();
  for (const auto& [a, b, fraction] : points) {
    positions.push_back((1 - fraction) * mesh.point(a) + fraction * mesh.point(b));
  }
  Facets facets;
  std::vector<int> parents;
  for (int f = 0; f < mesh.facet_count(); ++f) {
    triangulate(polygon_of(mesh.facet(f), added), facets);
    parents.resize(facets.size(), f);
  }
  return {TriMesh(std::move(positions), std::move(facets)), std::move(parents), points};
}

SurfacePoint EdgeSplitMesh::on_original(const TriMesh& original, const SurfacePoint& point) const {
  SurfacePoint result{parent_facet[point.facet], Vec3::Zero()};
  const Facet& parent = original.facet(result.facet);
  auto add = [&](int vertex, double weight) {
    const auto corner = std::find(parent.begin(), parent.end(), vertex) - parent.begin();
    result.barycentric[corner] += weight;
  };
  for (int i = 0; i < 3; ++i) {
    const int vertex = mesh.facet(point.facet)[i];
    if (vertex < original.vertex_count()) {
      add(vertex, point.barycentric[i]);
      continue;
    }
    const EdgePoint& place = points[vertex - original.vertex_count()];
    add(place.a, (1 - place.fraction) * point.barycentric[i]);
    add(place.b, place.fraction * point.barycentric[i]);
  }
  return result;
}

}  // namespace partwise
