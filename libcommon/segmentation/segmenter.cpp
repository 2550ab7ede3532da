#include "segmentation/segmenter.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <utility>

#include "error.h"
#include "segmentation/crease_field.h"
#include "segmentation/ears.h"
#include "segmentation/growth.h"
#include "segmentation/split_boundaries.h"

namespace partwise {
namespace {

/// The sketch for a mesh with the same vertices and surface, but other facets than the one of `places`.
Sketch without_facets(Sketch sketch, const TriMesh& mesh, SurfacePlaces& places) {
  auto resolve = [&](Place& place, const std::string& where) {
    if (std::holds_alternative<SurfacePoint>(place)) place = position(mesh, places.locate(place, where));
  };
  for (SketchedMarker& marker : sketch.markers) resolve(marker.place, "marker '" + marker.name + "'");
  for (SketchedAnchor& anchor : sketch.anchors) resolve(anchor.place, "anchor '" + anchor.name + "'");
  sketch.mesh.reset();
  return sketch;
}

RepairedLabels grow(const TriMesh& mesh, const std::vector<std::string>& names, const Seeds& seeds,
                    const SegmentationOptions& options) {
  // To look for creases takes longer than the growth itself.
  const std::vector<double> no_creases(mesh.half_edges().n_edges(), 0.0);
  RepairedLabels grown =
      repair_labels(mesh, names, seeds, grow_regions(mesh, seeds), boundary_costs(mesh, no_creases));
  if (!options.refine_growth || mesh.facet_count() > options.largest_refined) return grown;
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

}  // namespace

Segmenter::Segmenter(const TriMesh& mesh, const SegmentationOptions& options)
    : mesh_(mesh), options_(options), places_(mesh_, options.snap_limit) {}

void Segmenter::prepare() {
  make_kept(options_.method == SegmentationMethod::walker);
}

void Segmenter::make_kept(bool needs_labeller) {
  const auto find_components = [&] {
    if (components_.empty()) components_ = facet_components(mesh_);
  };
  const auto make_labeller = [&] {
    if (needs_labeller && !labeller_) labeller_.emplace(mesh_, options_.largest_exact);
  };
  tbb::parallel_invoke(find_components, make_labeller);
}

void Segmenter::require_one_component() const {
  const auto second = std::find(components_.begin(), components_.end(), 1);
  if (second == components_.end()) return;
  throw InputError("the mesh has " +
                   std::to_string(1 + *std::max_element(components_.begin(), components_.end())) +
                   " components (facet " + std::to_string(second - components_.begin()) +
                   " is not connected to facet 0) but one part; give each component a part of its own, or "
                   "keep the largest (convert-mesh --keep-largest-component)");
}

const SeparatedLabels& Segmenter::labels_for(const std::vector<std::string>& names,
                                             std::vector<SeedStroke> strokes, const Seeds& seeds) {
  if (!last_ || last_->names != names || last_->strokes != strokes) {
    last_.reset();
    last_.emplace(Labelled{names, std::move(strokes), label_facets(names, seeds)});
  }
  return last_->labels;
}

SeparatedLabels Segmenter::label_facets(const std::vector<std::string>& names, const Seeds& seeds) {
  if (names.size() == 1) {
    require_one_component();
    RepairedLabels whole;
    whole.labels.assign(mesh_.facet_count(), 0);
    return {whole, {}};
  }
  if (options_.method == SegmentationMethod::growth) {
    return {remove_ears(mesh_, seeds, grow(mesh_, names, seeds, options_)), {}};
  }
  const int part_count = static_cast<int>(names.size());
  const std::vector<double>& costs = labeller_->boundary_costs();
  RepairedLabels repaired =
      repair_labels(mesh_, names, seeds, labeller_->labels(seeds, part_count, options_.band_cut), costs);
  SeparatedLabels separated =
      separate_contacts(mesh_, names, seeds, std::move(repaired), costs, options_.contact_limit);
  separated.repaired = remove_ears(mesh_, seeds, std::move(separated.repaired));
  return separated;
}

SegmentedMesh Segmenter::split(const Sketch& sketch, const std::vector<std::string>& names,
                               const Seeds& seeds, RepairedLabels repaired) {
  SplitMeshLabels cut = split_along_boundaries(mesh_, names, seeds, repaired.labels, options_.split_rounds);
  repaired.labels = std::move(cut.labels);
  SegmentedMesh result =
      assemble_segmentation(cut.mesh, std::move(repaired), without_facets(sketch, mesh_, places_), options_);
  result.added_vertices = cut.added_vertices;
  result.added_facets = cut.added_facets;
  return result;
}

SegmentedMesh Segmenter::segment(const Sketch& sketch) {
  require_drawn_for(mesh_, sketch);
  const std::vector<std::string> names = part_names(sketch);
  std::vector<SeedStroke> strokes = seed_strokes(sketch, places_);
  make_kept(names.size() > 1 && options_.method == SegmentationMethod::walker);
  const Seeds seeds = names.size() > 1 ? collect_seeds(mesh_, components_, names, strokes) : Seeds();
  const SeparatedLabels& labelled = labels_for(names, std::move(strokes), seeds);
  SegmentedMesh result = options_.split_edges && names.size() > 1
                             ? split(sketch, names, seeds, labelled.repaired)
                             : assemble_segmentation(mesh_, labelled.repaired, sketch, options_, places_);
  for (const std::string& contact : labelled.sentences) result.warnings.push_back(contact);
  const bool is_grown = options_.method == SegmentationMethod::growth && !sketch.parts.empty();
  if (is_grown && options_.refine_growth && mesh_.facet_count() > options_.largest_refined) {
    result.warnings.push_back(
        "boundaries are as the growth leaves them: straightening them is for meshes of at most " +
        std::to_string(options_.largest_refined) + " facets; --method walker straightens those of any");
  }
  return result;
}

}  // namespace partwise
