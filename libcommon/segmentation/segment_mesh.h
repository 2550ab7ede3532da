#pragma once

#include <string>
#include <vector>

#include "mesh/segmentation.h"
#include "segmentation/boundary_refinement.h"
#include "segmentation/cut_proposals.h"
#include "segmentation/label_repair.h"
#include "segmentation/sketch.h"
#include "segmentation/surface_places.h"

namespace partwise {

enum class SegmentationMethod {
  walker,  ///< random walker over facets, boundaries cut in a narrow band, see random_walker.h and band_cut.h
  growth   ///< as in the paper, see growth.h and boundary_refinement.h
};

struct SegmentationOptions {
  SegmentationMethod method = SegmentationMethod::walker;
  BandCutOptions band_cut;
  int largest_exact = 50'000;  ///< facets of the largest mesh that is cut on one level; others coarse to fine
  bool refine_growth = true;   ///< straighten the boundaries that growth leaves, see boundary_refinement.h
  RefinementOptions refinement;
  double contact_limit =
      0.35;  ///< contacts of the walker's parts up to this share of their boundary are taken for accidental
  int largest_refined = 200'000;  ///< facets of the largest mesh whose growth is: beyond, it takes minutes
  double snap_limit = 0.05;       ///< how far sketched points may lie from the surface, over the diagonal
  bool split_edges = false;      ///< boundaries may cross facets, which are cut there, see split_boundaries.h
  int split_rounds = 8;          ///< of averaging along boundaries before facets are cut
  bool propose_anchors = false;  ///< adds anchors marked as proposed, see anchor_proposals.h
  bool measure_concavity = true;  ///< of the parts; takes about as long as cutting a large mesh. Without it
                                  ///< no part is said to be too concave
  double tau = 0.1;  ///< concavity above which a part should be decomposed further, over the diagonal
  bool propose_cuts = false;  ///< with measure_concavity, says where; takes about as long again as the
                              ///< segmentation of such a part
};

/// A segmented model, and what making it took.
struct SegmentedMesh {
  SegmentedModel model;
  std::vector<std::string> warnings;  ///< decomposition hints, boundaries without anchors: a sentence each
  std::vector<CutProposal> cuts;      ///< with propose_cuts, for parts that are too concave
  int merged_islands = 0;             ///< surplus components of parts given to a neighbour
  int removed_pinches = 0;            ///< places where a part touched itself at a vertex
  int changed_facets = 0;             ///< by these two
  int added_vertices = 0;             ///< by splitting edges: they come after the mesh's own
  int added_facets = 0;
};

/// Cuts a mesh into the parts of a sketch and places the sketch's markers and anchors ([Wu11] 4.2).
///
/// Every part is connected, its boundaries are simple curves of edges: of the mesh as it is, or with
/// split_edges of one with more vertices, whose first are the mesh's. The result does not change when the
/// model is scaled, moved or renumbered, apart from ties in a symmetric model; rotating it changes the
/// diagonal that the crease field is relative to, by little. A sketch with fewer than two parts makes the
/// whole mesh one part, called "whole" when the sketch does not name it.
///
/// \throws InputError naming part, stroke and entry (or marker, anchor) when sketch and mesh do not fit, a
///         component of the mesh has no stroke, a part would be empty; ComputationError naming the vertex
///         where boundaries cannot be made simple.
SegmentedMesh segment_mesh(const TriMesh& mesh, const Sketch& sketch, const SegmentationOptions& options);

/// The last steps of segment_mesh: boundaries, markers, anchors and hints of facets that have their labels.
/// \param landmarks names the parts, in the order of the labels, and the markers and anchors
/// \pre labels as repair_labels() leaves them: one per facet, each the index of a part
/// \throws InputError as segment_mesh
SegmentedMesh assemble_segmentation(const TriMesh& mesh, RepairedLabels repaired, const Sketch& landmarks,
                                    const SegmentationOptions& options);

/// The same with a search tree that is kept.
SegmentedMesh assemble_segmentation(const TriMesh& mesh, RepairedLabels repaired, const Sketch& landmarks,
                                    const SegmentationOptions& options, SurfacePlaces& places);

}  // namespace partwise
