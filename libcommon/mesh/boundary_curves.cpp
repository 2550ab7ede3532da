#include <algorithm>
#include <map>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>

#include "error.h"
#include "mesh/facet_regions.h"
#include "mesh/segmentation.h"

namespace partwise {
namespace {

using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

class Tracer {
 public:
  Tracer(const TriMesh& mesh, const Segmentation& segmentation)
      : mesh_(mesh), half_edges_(mesh.half_edges()), segmentation_(segmentation) {}

  /// Label on the left of a half-edge.
  int label(HalfedgeHandle h) const {
    const FaceHandle f = half_edges_.face_handle(h);
    return f.is_valid() ? segmentation_.labels[f.idx()] : kOutside;
  }

  /// The half-edge is walked as part of a curve: its left part is the smaller one, the outside is on the
  /// right.
  bool is_boundary(HalfedgeHandle h) const {
    const int left = label(h);
    const int right = label(half_edges_.opposite_halfedge_handle(h));
    return left != kOutside && (right == kOutside || left < right);
  }

  /// Labels around a vertex in cyclic order, runs of equal labels once.
  std::vector<int> label_word(VertexHandle v) const {
    std::vector<int> word;
    for (const HalfedgeHandle h : half_edges_.voh_range(v)) {
      if (word.empty() || word.back() != label(h)) word.push_back(label(h));
    }
    if (word.size() > 1 && word.front() == word.back()) word.pop_back();
    return word;
  }

  /// Half-edges walked as part of a curve, ascending: few, so that what follows need not see the whole mesh.
  std::vector<HalfedgeHandle> boundary() const {
    std::vector<HalfedgeHandle> result;
    for (int i = 0; i < static_cast<int>(half_edges_.n_halfedges()); ++i) {
      if (is_boundary(HalfedgeHandle(i))) result.emplace_back(i);
    }
    return result;
  }

  void require_connected_parts() const;
  CrossPoint cross_point(VertexHandle v, const std::vector<int>& word) const;
  std::vector<BoundaryCurve> curves(const std::vector<HalfedgeHandle>& boundary,
                                    const std::vector<bool>& is_cross_point) const;

 private:
  /// The next half-edge of the curve that `h` belongs to: turn around its end vertex until the labels change.
  HalfedgeHandle next(HalfedgeHandle h) const {
    const int right = label(half_edges_.opposite_halfedge_handle(h));
    HalfedgeHandle candidate = half_edges_.next_halfedge_handle(h);
    const int left = label(h);
    while (label(half_edges_.opposite_halfedge_handle(candidate)) == left) {
      candidate = half_edges_.next_halfedge_handle(half_edges_.opposite_halfedge_handle(candidate));
    }
    return label(half_edges_.opposite_halfedge_handle(candidate)) == right ? candidate : HalfedgeHandle();
  }

  BoundaryCurve walk(HalfedgeHandle start, const std::vector<bool>& is_cross_point,
                     std::vector<bool>& visited) const;

  const TriMesh& mesh_;
  const HalfEdges& half_edges_;
  const Segmentation& segmentation_;
};

void Tracer::require_connected_parts() const {
  const std::vector<int> region = facet_regions(mesh_, segmentation_.labels);
  std::vector<int> first_facet(segmentation_.part_count(), -1);
  for (int f = 0; f < mesh_.facet_count(); ++f) {
    const int part = segmentation_.labels[f];
    if (first_facet[part] < 0) first_facet[part] = f;
    if (region[f] != first_facet[part]) {
      throw InputError("part '" + segmentation_.names[part] + "' is not connected: facet " +
                       std::to_string(f) + " does not reach facet " + std::to_string(first_facet[part]));
    }
  }
  for (int part = 0; part < segmentation_.part_count(); ++part) {
    if (first_facet[part] < 0) throw InputError("part '" + segmentation_.names[part] + "' has no facets");
  }
}

CrossPoint Tracer::cross_point(VertexHandle v, const std::vector<int>& word) const {
  std::vector<int> sorted = word;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end()) {
    const std::string part =
        *twice == kOutside ? "the mesh's boundary" : "part '" + segmentation_.names[*twice] + "'";
    throw InputError(part + " is pinched at vertex " + std::to_string(v.idx()) +
                     ": its facets there form more than one fan");
  }
  CrossPoint point{v.idx(), word};
  std::rotate(point.parts.begin(), std::min_element(point.parts.begin(), point.parts.end()),
              point.parts.end());
  return point;
}

BoundaryCurve Tracer::walk(HalfedgeHandle start, const std::vector<bool>& is_cross_point,
                           std::vector<bool>& visited) const {
  BoundaryCurve curve;
  curve.left = label(start);
  curve.right = label(half_edges_.opposite_halfedge_handle(start));
  curve.vertices.push_back(half_edges_.from_vertex_handle(start).idx());
  HalfedgeHandle h = start;
  while (true) {
    visited[h.idx()] = true;
    const int end = half_edges_.to_vertex_handle(h).idx();
    curve.length += (mesh_.point(end) - mesh_.point(half_edges_.from_vertex_handle(h).idx())).norm();
    if (end == curve.vertices.front()) {
      curve.closed = !is_cross_point[end];
      if (is_cross_point[end]) curve.vertices.push_back(end);
      break;
    }
    curve.vertices.push_back(end);
    if (is_cross_point[end]) break;
    h = next(h);
  }
  if (curve.closed) {
    std::rotate(curve.vertices.begin(), std::min_element(curve.vertices.begin(), curve.vertices.end()),
                curve.vertices.end());
  }
  return curve;
}

std::vector<BoundaryCurve> Tracer::curves(const std::vector<HalfedgeHandle>& boundary,
                                          const std::vector<bool>& is_cross_point) const {
  std::vector<BoundaryCurve> result;
  std::vector<bool> visited(half_edges_.n_halfedges(), false);
  auto collect = [&](HalfedgeHandle h) {
    if (!visited[h.idx()]) result.push_back(walk(h, is_cross_point, visited));
  };
  // Arcs first, from their cross points: what is left over then closes on itself.
  for (const HalfedgeHandle h : boundary) {
    if (is_cross_point[half_edges_.from_vertex_handle(h).idx()]) collect(h);
  }
  for (const HalfedgeHandle h : boundary) collect(h);
  auto order = [](const BoundaryCurve& c) {
    return std::tuple(c.left, c.right, *std::min_element(c.vertices.begin(), c.vertices.end()), c.vertices);
  };
  std::sort(result.begin(), result.end(),
            [&](const BoundaryCurve& a, const BoundaryCurve& b) { return order(a) < order(b); });
  return result;
}

}  // namespace

int part_index(const Segmentation& segmentation, const std::string& name) {
  const auto found = std::find(segmentation.names.begin(), segmentation.names.end(), name);
  return found == segmentation.names.end() ? -1 : static_cast<int>(found - segmentation.names.begin());
}

Segmentation trace_boundaries(const TriMesh& mesh, std::vector<std::string> names, std::vector<int> labels) {
  const auto part_count = static_cast<int>(names.size());
  if (static_cast<int>(labels.size()) != mesh.facet_count()) {
    throw InputError("expected one label for each of " + std::to_string(mesh.facet_count()) +
                     " facets, got " + std::to_string(labels.size()));
  }
  for (std::size_t f = 0; f < labels.size(); ++f) {
    if (labels[f] < 0 || labels[f] >= part_count) {
      throw InputError("facet " + std::to_string(f) + " has the label " + std::to_string(labels[f]) +
                       ", but there are " + std::to_string(part_count) + " parts");
    }
  }
  const Segmentation segmentation{std::move(names), std::move(labels), {}, {}};
  Tracer(mesh, segmentation).require_connected_parts();
  return trace_connected_parts(mesh, segmentation.names, segmentation.labels);
}

Segmentation trace_connected_parts(const TriMesh& mesh, std::vector<std::string> names,
                                   std::vector<int> labels) {
  Segmentation segmentation{std::move(names), std::move(labels), {}, {}};
  const Tracer tracer(mesh, segmentation);
  const std::vector<HalfedgeHandle> boundary = tracer.boundary();
  std::vector<bool> is_cross_point(mesh.vertex_count(), false), is_on_boundary(mesh.vertex_count(), false);
  for (const HalfedgeHandle h : boundary) {
    is_on_boundary[mesh.half_edges().from_vertex_handle(h).idx()] = true;
    is_on_boundary[mesh.half_edges().to_vertex_handle(h).idx()] = true;
  }
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (!is_on_boundary[v]) continue;
    const std::vector<int> word = tracer.label_word(VertexHandle(v));
    if (word.size() < 3) continue;
    segmentation.cross_points.push_back(tracer.cross_point(VertexHandle(v), word));
    is_cross_point[v] = true;
  }
  segmentation.curves = tracer.curves(boundary, is_cross_point);
  return segmentation;
}

}  // namespace partwise
