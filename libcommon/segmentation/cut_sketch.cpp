#include "segmentation/cut_sketch.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "segmentation/surface_places.h"

namespace partwise {
namespace {

/// Pieces among the facets at a vertex; those outside the part do not count.
std::set<int> pieces_at(const TriMesh& mesh, const std::vector<int>& piece_of_facet, int vertex) {
  std::set<int> pieces;
  for (const auto f : mesh.half_edges().vf_range(OpenMesh::VertexHandle(vertex))) {
    if (piece_of_facet[f.idx()] >= 0) pieces.insert(piece_of_facet[f.idx()]);
  }
  return pieces;
}

/// The vertices of a stroke, in the order in which it was drawn where that is known.
std::vector<int> drawn_vertices(const Stroke& stroke, SurfacePlaces& places, const std::string& where) {
  if (const auto* given = std::get_if<VertexStroke>(&stroke)) return given->vertices;
  const auto* near = std::get_if<PointStroke>(&stroke);
  if (near == nullptr) return places.stroke_vertices(stroke, where);
  std::vector<int> vertices;
  for (const Vec3& point : near->points) {
    const std::vector<int> one = places.stroke_vertices(PointStroke{{point}}, where);
    vertices.insert(vertices.end(), one.begin(), one.end());
  }
  return vertices;
}

/// Adds a stroke of the old part to the pieces that it runs through, cut where it crosses from one to
/// another.
void share_out(const TriMesh& mesh, const CutProposal& proposal, const Stroke& stroke, SurfacePlaces& places,
               std::vector<std::vector<Stroke>>& strokes) {
  std::vector<std::pair<int, VertexStroke>> runs;  // each within a piece
  int before = -1;
  bool stays = true;
  for (const int v : drawn_vertices(stroke, places, "part '" + proposal.pieces[0].name + "'")) {
    const std::set<int> pieces = pieces_at(mesh, proposal.piece_of_facet, v);
    const int piece = pieces.size() == 1 ? *pieces.begin() : -1;  // none: on a cut
    stays = stays && piece == 0;
    if (piece >= 0 && piece != before) runs.push_back({piece, {}});
    if (piece >= 0) runs.back().second.vertices.push_back(v);
    before = piece;
  }
  if (stays) {
    strokes[0].push_back(stroke);
  } else {
    for (auto& [piece, run] : runs) strokes[piece].emplace_back(std::move(run));
  }
}

/// The sketch's parts with the pieces of the proposals.
std::vector<SketchedPart> cut_parts(const TriMesh& mesh, const Sketch& sketch,
                                    const std::vector<CutProposal>& proposals, SurfacePlaces& places) {
  std::vector<SketchedPart> parts = sketch.parts;
  if (parts.empty()) parts.push_back({part_names(sketch).front(), {}});
  for (const CutProposal& proposal : proposals) {
    std::vector<std::vector<Stroke>> strokes(proposal.pieces.size());
    for (const Stroke& stroke : parts[proposal.part].strokes) {
      share_out(mesh, proposal, stroke, places, strokes);
    }
    for (std::size_t k = 0; k < strokes.size(); ++k) {
      const ProposedPiece& piece = proposal.pieces[k];
      strokes[k].insert(strokes[k].end(), piece.strokes.begin(), piece.strokes.end());
      if (k == 0) {
        parts[proposal.part].strokes = std::move(strokes[k]);
      } else {
        parts.push_back({piece.name, std::move(strokes[k])});
      }
    }
  }
  return parts;
}

/// Names that a part's pieces have; its own where it is not cut.
std::vector<std::string> pieces_named(const std::vector<CutProposal>& proposals, const std::string& part) {
  for (const CutProposal& proposal : proposals) {
    if (proposal.pieces[0].name != part) continue;
    std::vector<std::string> names;
    for (const ProposedPiece& piece : proposal.pieces) names.push_back(piece.name);
    return names;
  }
  return {part};
}

double distance_to(const TriMesh& mesh, const BoundaryCurve& curve, const Vec3& place) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const int v : curve.vertices) nearest = std::min(nearest, (mesh.point(v) - place).norm());
  return nearest;
}

/// The two parts, of those that the anchor's parts were cut into, whose boundary is nearest; none when they
/// share no boundary.
std::optional<std::array<std::string, 2>> new_parts(const SketchedAnchor& anchor, const Vec3& place,
                                                    const SegmentedModel& after,
                                                    const std::vector<CutProposal>& proposals) {
  const std::vector<std::string> first = pieces_named(proposals, anchor.between[0]);
  const std::vector<std::string> second = pieces_named(proposals, anchor.between[1]);
  const auto among = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  std::optional<std::array<std::string, 2>> best;
  double nearest = std::numeric_limits<double>::infinity();
  for (const BoundaryCurve& curve : after.segmentation.curves) {
    if (curve.right == kOutside) continue;
    std::string a = after.segmentation.names[curve.left], b = after.segmentation.names[curve.right];
    if (!among(first, a)) std::swap(a, b);
    if (!among(first, a) || !among(second, b)) continue;
    const double distance = distance_to(after.mesh, curve, place);
    if (distance >= nearest) continue;
    nearest = distance;
    best = {a, b};
  }
  return best;
}

}  // namespace

CutSketch with_cuts(const Sketch& sketch, const SegmentedMesh& segmented, SegmentationOptions options) {
  const TriMesh& mesh = segmented.model.mesh;
  SurfacePlaces places(mesh, options.snap_limit);
  options.propose_cuts = false;
  CutSketch result{sketch, 0, {}};
  result.sketch.parts = cut_parts(mesh, sketch, segmented.cuts, places);
  result.sketch.mesh = SketchedMesh{mesh.vertex_count(), mesh.facet_count()};
  result.sketch.anchors.clear();
  const SegmentedModel after = segment_mesh(mesh, result.sketch, options).model;
  for (const Concavity& part : after.concavity) {
    result.largest_concavity = std::max(result.largest_concavity, part.largest);
  }
  for (SketchedAnchor anchor : sketch.anchors) {
    const Vec3 place = position(mesh, places.locate(anchor.place, "anchor '" + anchor.name + "'"));
    if (const auto between = new_parts(anchor, place, after, segmented.cuts)) {
      anchor.between = *between;
      result.sketch.anchors.push_back(std::move(anchor));
    } else {
      result.lost_anchors.push_back(anchor.name);
    }
  }
  return result;
}

}  // namespace partwise
