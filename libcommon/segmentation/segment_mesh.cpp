#include "segmentation/segment_mesh.h"

#include <tbb/parallel_invoke.h>

#include <utility>

#include "segmentation/anchor_proposals.h"
#include "segmentation/concavity.h"
#include "segmentation/landmarks.h"
#include "segmentation/segmenter.h"

namespace partwise {

SegmentedMesh assemble_segmentation(const TriMesh& mesh, RepairedLabels repaired, const Sketch& landmarks,
                                    const SegmentationOptions& options, SurfacePlaces& places) {
  require_drawn_for(mesh, landmarks);
  const std::vector<std::string> names = part_names(landmarks);
  const std::vector<int>& labels = repaired.labels;
  Segmentation segmentation;
  std::vector<Concavity> concavity;
  tbb::parallel_invoke([&] { segmentation = trace_boundaries(mesh, names, labels); },
                       [&] {
                         if (!options.measure_concavity) return;
                         concavity = measure_concavity(mesh, labels, static_cast<int>(names.size()));
                       });
  std::vector<Marker> markers = place_markers(landmarks, places);
  std::vector<Anchor> anchors = place_anchors(mesh, segmentation, landmarks, places);
  std::vector<CutProposal> cuts;
  std::vector<std::string> warnings;
  if (options.measure_concavity) {
    if (options.propose_cuts) cuts = propose_cuts(mesh, segmentation, concavity, options.tau);
    warnings = decomposition_hints(mesh, segmentation, concavity, options.tau, cuts);
  }
  for (std::string& sentence : unanchored_curves(segmentation, anchors)) {
    warnings.push_back(std::move(sentence));
  }
  if (options.propose_anchors) {
    const std::vector<Anchor> proposals = propose_anchors(mesh, segmentation, markers, anchors);
    anchors.insert(anchors.end(), proposals.begin(), proposals.end());
  }
  return {{mesh, std::move(segmentation), std::move(markers), std::move(anchors), std::move(concavity)},
          std::move(warnings),
          std::move(cuts),
          repaired.merged_islands,
          repaired.removed_pinches,
          repaired.changed_facets};
}

SegmentedMesh assemble_segmentation(const TriMesh& mesh, RepairedLabels repaired, const Sketch& landmarks,
                                    const SegmentationOptions& options) {
  SurfacePlaces places(mesh, options.snap_limit);
  return assemble_segmentation(mesh, std::move(repaired), landmarks, options, places);
}

SegmentedMesh segment_mesh(const TriMesh& mesh, const Sketch& sketch, const SegmentationOptions& options) {
  return Segmenter(mesh, options).segment(sketch);
}

}  // namespace partwise
