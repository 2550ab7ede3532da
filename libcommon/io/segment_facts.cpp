#include "io/segment_facts.h"

#include <algorithm>
#include <utility>

#include "mesh/curve_roughness.h"

namespace partwise::io {

Json segment_metrics(const SegmentedMesh& segmented) {
  const SegmentedModel& model = segmented.model;
  double snap = 0, concavity = 0;
  for (const Anchor& anchor : model.anchors) snap = std::max(snap, anchor.snap_distance);
  for (const Concavity& part : model.concavity) concavity = std::max(concavity, part.largest);
  return {{"parts", model.segmentation.part_count()},
          {"curves", model.segmentation.curves.size()},
          {"proposed_anchors", std::count_if(model.anchors.begin(), model.anchors.end(),
                                             [](const Anchor& a) { return a.proposed; })},
          {"cross_points", model.segmentation.cross_points.size()},
          {"merged_islands", segmented.merged_islands},
          {"removed_pinches", segmented.removed_pinches},
          {"changed_facets", segmented.changed_facets},
          {"added_vertices", segmented.added_vertices},
          {"added_facets", segmented.added_facets},
          {"mean_roughness", mean_roughness(model.mesh, model.segmentation)},
          {"largest_snap_distance", snap / model.mesh.diagonal()},
          {"largest_concavity", concavity}};
}

Json cut_facts(const SegmentedMesh& segmented) {
  Json cuts = Json::array();
  for (const CutProposal& proposal : segmented.cuts) {
    Json pieces = Json::array(), curves = Json::array();
    for (const ProposedPiece& piece : proposal.pieces) {
      Json strokes = Json::array();
      for (const VertexStroke& stroke : piece.strokes) strokes.push_back({{"vertices", stroke.vertices}});
      pieces.push_back({{"name", piece.name},
                        {"strokes", std::move(strokes)},
                        {"concavity",
                         {{"largest", piece.concavity.largest},
                          {"mean", piece.concavity.mean},
                          {"vertex", piece.concavity.vertex}}}});
    }
    for (const BoundaryCurve& curve : proposal.curves) {
      curves.push_back({{"between", {proposal.pieces[curve.left].name, proposal.pieces[curve.right].name}},
                        {"closed", curve.closed},
                        {"length", curve.length},
                        {"vertices", curve.vertices}});
    }
    cuts.push_back({{"part", segmented.model.segmentation.names[proposal.part]},
                    {"pieces", std::move(pieces)},
                    {"curves", std::move(curves)}});
  }
  return cuts;
}

}  // namespace partwise::io
