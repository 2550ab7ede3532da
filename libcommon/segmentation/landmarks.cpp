#include "segmentation/landmarks.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "error.h"

namespace partwise {
namespace {

/// An anchor that could take `vertex`, at `distance` from where the user put it.
struct Candidate {
  double distance;
  std::size_t anchor;
  int vertex;
  bool operator<(const Candidate& other) const {
    return std::tie(distance, anchor, vertex) < std::tie(other.distance, other.anchor, other.vertex);
  }
};

std::vector<int> shared_vertices(const Segmentation& segmentation, int part_a, int part_b) {
  std::set<int> vertices;
  for (const BoundaryCurve& curve : segmentation.curves) {
    if (std::minmax(part_a, part_b) != std::minmax(curve.left, curve.right)) continue;
    vertices.insert(curve.vertices.begin(), curve.vertices.end());
  }
  return {vertices.begin(), vertices.end()};
}

std::string quoted(const std::string& name) {
  return "'" + name + "'";
}

}  // namespace

std::vector<Marker> place_markers(const Sketch& sketch, SurfacePlaces& places) {
  std::vector<Marker> markers;
  for (const SketchedMarker& marker : sketch.markers) {
    markers.push_back({marker.name, places.locate(marker.place, "marker " + quoted(marker.name))});
  }
  return markers;
}

std::vector<Anchor> place_anchors(const TriMesh& mesh, const Segmentation& segmentation, const Sketch& sketch,
                                  SurfacePlaces& places) {
  std::vector<Anchor> anchors;
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < sketch.anchors.size(); ++i) {
    const SketchedAnchor& sketched = sketch.anchors[i];
    const std::string where = "anchor " + quoted(sketched.name);
    Anchor anchor{sketched.name, part_index(segmentation, sketched.between[0]),
                  part_index(segmentation, sketched.between[1])};
    anchor.vertex = -1;
    const Vec3 wish = position(mesh, places.locate(sketched.place, where));
    const std::vector<int> shared = shared_vertices(segmentation, anchor.part_a, anchor.part_b);
    if (shared.empty()) {
      throw InputError(where + ": the parts " + quoted(sketched.between[0]) + " and " +
                       quoted(sketched.between[1]) +
                       " share no boundary; draw strokes on both sides of where they should meet");
    }
    for (const int v : shared) candidates.push_back({(mesh.point(v) - wish).norm(), i, v});
    anchors.push_back(std::move(anchor));
  }
  std::sort(candidates.begin(), candidates.end());
  std::set<int> taken;
  for (const Candidate& candidate : candidates) {
    Anchor& anchor = anchors[candidate.anchor];
    if (anchor.vertex >= 0 || !taken.insert(candidate.vertex).second) continue;
    anchor.vertex = candidate.vertex;
    anchor.snap_distance = candidate.distance;
  }
  for (const Anchor& anchor : anchors) {
    if (anchor.vertex < 0) {
      throw InputError("anchor " + quoted(anchor.name) + ": other anchors took every vertex of its boundary");
    }
  }
  return anchors;
}

std::vector<std::string> unanchored_curves(const Segmentation& segmentation,
                                           const std::vector<Anchor>& anchors) {
  std::vector<std::string> sentences;
  for (const BoundaryCurve& curve : segmentation.curves) {
    if (!curve.closed || curve.right == kOutside) continue;
    const auto count = std::count_if(anchors.begin(), anchors.end(), [&](const Anchor& anchor) {
      return std::find(curve.vertices.begin(), curve.vertices.end(), anchor.vertex) != curve.vertices.end();
    });
    if (count >= 2) continue;
    sentences.push_back("the boundary between " + quoted(segmentation.names[curve.left]) + " and " +
                        quoted(segmentation.names[curve.right]) + " (through vertex " +
                        std::to_string(curve.vertices.front()) + ") has " +
                        (count == 0 ? "no anchor" : "1 anchor") +
                        "; name 2 or more in the sketch to fix how it corresponds");
  }
  return sentences;
}

std::vector<int> parts_at(const TriMesh& mesh, const Segmentation& segmentation, const SurfacePoint& point) {
  std::set<int> parts{segmentation.labels[point.facet]};
  const HalfEdges& half_edges = mesh.half_edges();
  for (int corner = 0; corner < 3; ++corner) {
    const int next = (corner + 1) % 3, last = (corner + 2) % 3;
    const OpenMesh::VertexHandle v(mesh.facet(point.facet)[corner]);
    if (point.barycentric[corner] == 1) {
      for (const OpenMesh::FaceHandle f : half_edges.vf_range(v)) parts.insert(segmentation.labels[f.idx()]);
    }
    if (point.barycentric[last] == 0) {
      const auto h = half_edges.find_halfedge(OpenMesh::VertexHandle(mesh.facet(point.facet)[next]), v);
      if (half_edges.face_handle(h).is_valid()) {
        parts.insert(segmentation.labels[half_edges.face_handle(h).idx()]);
      }
    }
  }
  return {parts.begin(), parts.end()};
}

}  // namespace partwise
