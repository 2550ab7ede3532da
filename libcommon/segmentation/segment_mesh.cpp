#include "segmentation/segment_mesh.h"

#include <algorithm>
#include <utility>

#include "error.h"
#include "segmentation/anchor_proposals.h"
#include "segmentation/concavity.h"
#include "segmentation/contacts.h"
#include "segmentation/crease_field.h"
#include "segmentation/growth.h"
#include "segmentation/label_repair.h"
#include "segmentation/landmarks.h"
#include "segmentation/random_walker.h"
#include "segmentation/surface_places.h"

namespace partwise {
namespace {

void require_size(const TriMesh& mesh, const Sketch& sketch) {
  if (!sketch.mesh) return;
  if (sketch.mesh->vertices == mesh.vertex_count() && sketch.mesh->facets == mesh.facet_count()) return;
  throw InputError("the sketch was drawn for a mesh of " + std::to_string(sketch.mesh->vertices) +
                   " vertices and " + std::to_string(sketch.mesh->facets) + " facets, this one has " +
                   std::to_string(mesh.vertex_count()) + " and " + std::to_string(mesh.facet_count()) +
                   "; take the sketch of this mesh");
}

std::vector<std::string> part_names(const Sketch& sketch) {
  if (sketch.parts.empty()) return {"whole"};
  std::vector<std::string> names;
  for (const SketchedPart& part : sketch.parts) names.push_back(part.name);
  return names;
}

void require_one_component(const TriMesh& mesh) {
  const std::vector<int> component = facet_components(mesh);
  const auto second = std::find(component.begin(), component.end(), 1);
  if (second == component.end()) return;
  throw InputError("the mesh has " +
                   std::to_string(1 + *std::max_element(component.begin(), component.end())) +
                   " components (facet " + std::to_string(second - component.begin()) +
                   " is not connected to facet 0) but one part; give each component a part of its own, or "
                   "keep the largest (convert-mesh --keep-largest-component)");
}

std::vector<int> raw_labels(const TriMesh& mesh, const Seeds& seeds, int part_count,
                            const std::vector<double>& concavity, const std::vector<double>& costs,
                            const SegmentationOptions& options) {
  const PartProbabilities probabilities = walk_randomly(mesh, seeds, part_count, concavity);
  if (mesh.facet_count() > options.largest_cut) return most_probable_parts(probabilities);
  return cut_band(mesh, seeds, probabilities, costs, options.band_cut);
}

RepairedLabels grow(const TriMesh& mesh, const std::vector<std::string>& names, const Seeds& seeds,
                    const SegmentationOptions& options) {
  // To look for creases takes longer than the growth itself.
  const std::vector<double> no_creases(mesh.half_edges().n_edges(), 0.0);
  RepairedLabels grown =
      repair_labels(mesh, names, seeds, grow_regions(mesh, seeds), boundary_costs(mesh, no_creases));
  if (!options.refine_growth || mesh.facet_count() > options.largest_cut) return grown;
  const std::vector<double> costs = boundary_costs(mesh, edge_concavity(mesh));
  const int part_count = static_cast<int>(names.size());
  RepairedLabels refined = repair_labels(
      mesh, names, seeds,
      refine_boundaries(mesh, seeds, part_count, std::move(grown.labels), costs, options.refinement), costs);
  refined.merged_islands += grown.merged_islands;
  refined.removed_pinches += grown.removed_pinches;
  refined.changed_facets += grown.changed_facets;
  return refined;
}

SeparatedLabels label_facets(const TriMesh& mesh, const std::vector<std::string>& names,
                             const std::vector<SeedStroke>& strokes, const SegmentationOptions& options) {
  if (names.size() == 1) {
    require_one_component(mesh);
    RepairedLabels whole;
    whole.labels.assign(mesh.facet_count(), 0);
    return {whole, {}};
  }
  const Seeds seeds = collect_seeds(mesh, names, strokes);
  if (options.method == SegmentationMethod::growth) return {grow(mesh, names, seeds, options), {}};
  const std::vector<double> concavity = edge_concavity(mesh);
  const std::vector<double> costs = boundary_costs(mesh, concavity);
  const int part_count = static_cast<int>(names.size());
  RepairedLabels repaired = repair_labels(
      mesh, names, seeds, raw_labels(mesh, seeds, part_count, concavity, costs, options), costs);
  return separate_contacts(mesh, names, seeds, std::move(repaired), costs, options.contact_limit);
}

}  // namespace

SegmentedMesh assemble_segmentation(const TriMesh& mesh, RepairedLabels repaired, const Sketch& landmarks,
                                    const SegmentationOptions& options) {
  require_size(mesh, landmarks);
  Segmentation segmentation = trace_boundaries(mesh, part_names(landmarks), std::move(repaired.labels));
  SurfacePlaces places(mesh, options.snap_limit);
  std::vector<Marker> markers = place_markers(landmarks, places);
  std::vector<Anchor> anchors = place_anchors(mesh, segmentation, landmarks, places);
  std::vector<Concavity> concavity = measure_concavity(mesh, segmentation);
  std::vector<std::string> warnings = decomposition_hints(segmentation, concavity, options.tau);
  for (std::string& sentence : unanchored_curves(segmentation, anchors)) {
    warnings.push_back(std::move(sentence));
  }
  if (options.propose_anchors) {
    const std::vector<Anchor> proposals = propose_anchors(mesh, segmentation, markers, anchors);
    anchors.insert(anchors.end(), proposals.begin(), proposals.end());
  }
  return {{mesh, std::move(segmentation), std::move(markers), std::move(anchors), std::move(concavity)},
          std::move(warnings),
          repaired.merged_islands,
          repaired.removed_pinches,
          repaired.changed_facets};
}

SegmentedMesh segment_mesh(const TriMesh& mesh, const Sketch& sketch, const SegmentationOptions& options) {
  require_size(mesh, sketch);
  const std::vector<std::string> names = part_names(sketch);
  SurfacePlaces places(mesh, options.snap_limit);
  SeparatedLabels labelled = label_facets(mesh, names, seed_strokes(sketch, places), options);
  SegmentedMesh result = assemble_segmentation(mesh, std::move(labelled.repaired), sketch, options);
  for (std::string& contact : labelled.sentences) result.warnings.push_back(std::move(contact));
  const bool walks = options.method == SegmentationMethod::walker;
  if ((walks || options.refine_growth) && names.size() > 1 && mesh.facet_count() > options.largest_cut) {
    result.warnings.push_back(std::string("boundaries are as the ") +
                              (walks ? "random walks leave" : "growth leaves") +
                              " them: straightening them is for meshes of at most " +
                              std::to_string(options.largest_cut) + " facets");
  }
  return result;
}

}  // namespace partwise
