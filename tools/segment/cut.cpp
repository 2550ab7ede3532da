#include <algorithm>
#include <iomanip>
#include <sstream>

#include "error.h"
#include "io/segment_facts.h"
#include "io/sketch.h"
#include "io/stage_documents.h"
#include "segment/modes.h"
#include "segmentation/cut_sketch.h"
#include "segmentation/segment_mesh.h"
#include "segmentation/transfer_labels.h"

namespace partwise::segment {
namespace {

io::Document document_of(const SegmentedMesh& segmented) {
  io::Document document = io::to_document(segmented.model);
  if (!segmented.cuts.empty()) document.metadata["proposed_cuts"] = io::cut_facts(segmented);
  return document;
}

/// Writes the sketch with the strokes of the proposed cuts.
void write_cuts(const cli::Command& command, const std::string& path, const Sketch& sketch,
                const SegmentedMesh& segmented, const SegmentationOptions& options) {
  const CutSketch cut = with_cuts(sketch, segmented, options);
  write_sketch(command, path, cut.sketch,
               "cuts suggested by segment --propose-cuts: to be looked at and corrected");
  if (segmented.cuts.empty()) {
    command.warn("no cut is proposed: " + path + " has no new part");
    return;
  }
  std::ostringstream said;
  said << std::setprecision(2) << "the " << cut.sketch.parts.size() << " parts in " << path
       << " are a suggestion, not a decision: with them no part lies more than " << cut.largest_concavity
       << " of the diagonal inside its hull; look at them, rename them as on the other model, correct the "
          "strokes, then segment with --sketch";
  command.warn(said.str());
  for (const std::string& anchor : cut.lost_anchors) {
    command.warn("anchor '" + anchor + "' is left out: the parts it lies between share no boundary any more");
  }
}

/// Takes the parts over from another segment document, with the landmarks of the sketch, if there is one.
void take_over(cli::Command& command, const io::Document& document, const std::string& about,
               const std::string& labels_path, const Sketch& sketch, const TransferOptions& options) {
  const io::Document labels = command.read(labels_path, {"segment"});
  command.note_input(io::digest(labels), labels.metadata.at("schema").get<std::string>());
  const SegmentedModel from = command.about(labels_path, [&] { return io::read_segmented_model(labels); });
  const bool has_strokes = std::any_of(sketch.parts.begin(), sketch.parts.end(),
                                       [](const SketchedPart& part) { return !part.strokes.empty(); });
  if (has_strokes) command.warn("the sketch's strokes are not used: the parts come from " + labels_path);
  const TransferredSegmentation result =
      command.about(about, [&] { return transfer_labels(io::read_mesh(document), from, sketch, options); });
  for (const std::string& warning : result.segmented.warnings) command.warn(warning);
  io::Json metrics = io::segment_metrics(result.segmented);
  metrics["labels"] = {{"copied", result.copied},
                       {"moved_area", result.moved_area},
                       {"mean_distance", result.mean_distance},
                       {"largest_distance", result.largest_distance}};
  std::ostringstream said;
  said << std::setprecision(3);
  if (result.copied) {
    said << "equal connectivity: labels, markers and anchors are copied";
  } else {
    said << "different connectivity: " << 100 * result.moved_area
         << " % of the area has another part than the closest facet";
  }
  command.inform(said.str());
  command.write(document_of(result.segmented), {&document}, metrics);
}

}  // namespace

int cut(cli::Command& command, int argc, char** argv) {
  const std::string& input = command.input("mesh", "Mesh document");
  command.output();
  TransferOptions transfer;
  SegmentationOptions& options = transfer.usual;
  options.propose_cuts = true;
  std::string labels_path, sketch_path, cuts_path, method = "walker", refines = "on";
  bool asks_check = false;  // never set: check() answers
  int suggested_parts = 0;  // likewise: suggest()
  command.options()
      .add_option("-s,--sketch", sketch_path, "Strokes, markers, anchors; without it the mesh is one part")
      ->type_name("FILE");
  command.options()
      .add_option(
          "--method", method,
          "walker: random walks, boundaries straightened; growth: cheapest step first, as in the paper")
      ->check(CLI::IsMember({"walker", "growth"}));
  command.options()
      .add_option("--refine-boundaries", refines,
                  "With --method growth: on straightens the boundaries, off leaves them as they grew")
      ->check(CLI::IsMember({"on", "off"}));
  command.options()
      .add_option("--tau", options.tau,
                  "Hint to decompose parts whose concavity exceeds this, over the diagonal")
      ->check(CLI::NonNegativeNumber);
  command.options()
      .add_option("--snap-limit", options.snap_limit,
                  "How far points of the sketch may lie from the surface, over the diagonal")
      ->check(CLI::NonNegativeNumber);
  CLI::Option* const labels_from =
      command.options()
          .add_option("--labels-from", labels_path,
                      "Segment document whose parts, markers and anchors to take over: copied when the "
                      "connectivity is equal, else from the closest facets; --sketch may add markers and "
                      "anchors, or replace those of equal name")
          ->type_name("FILE");
  CLI::Option* const cuts_to =
      command.options()
          .add_option(
              "--propose-cuts", cuts_path,
              "Also write the sketch with new parts added where parts exceed --tau, for you to judge and "
              "correct: X.sketch.json")
          ->type_name("FILE")
          ->excludes(labels_from);
  command.options()
      .add_flag("--split-edges", options.split_edges,
                "Let boundaries cross facets: smoother on coarse meshes, adds vertices and facets "
                "(the mesh's own vertices keep their numbers) and says how many")
      ->excludes(labels_from)
      ->excludes(cuts_to);
  command.options()
      .add_flag("--align-boxes", transfer.align_boxes,
                "With --labels-from: first bring the bounding box of its mesh onto this one's")
      ->needs(labels_from);
  command.options().add_flag(
      "--propose-anchors", options.propose_anchors,
      "Write two anchors for each closed boundary with fewer than two, marked as "
      "proposed: for you to judge and copy into the sketch; hull-to-hull leaves them out");
  command.options().add_flag("--check", asks_check,
                             "Compare segment documents instead: segment --check A B [C ...]");
  command.options()
      .add_option("--auto", suggested_parts,
                  "Suggest N parts instead, written as a sketch to correct: segment MESH --auto N "
                  "-o X.sketch.json")
      ->type_name("N");
  return command.run(argc, argv, [&] {
    const io::Document document = command.read(input, {"mesh"});
    const TriMesh mesh = command.about(input, [&] { return io::read_mesh(document); });
    options.method = method == "growth" ? SegmentationMethod::growth : SegmentationMethod::walker;
    options.refine_growth = refines == "on";
    const bool has_sketch = !sketch_path.empty();
    const std::string text = has_sketch ? command.read_text(sketch_path, "partwise/sketch-1") : "";
    const std::string& about = has_sketch ? sketch_path : input;
    const Sketch sketch =
        command.about(about, [&] { return has_sketch ? io::parse_sketch(text) : Sketch(); });
    if (!labels_path.empty()) {
      return take_over(command, document, about, labels_path, sketch, transfer);
    }
    const SegmentedMesh segmented = command.about(about, [&] { return segment_mesh(mesh, sketch, options); });
    for (const std::string& warning : segmented.warnings) command.warn(warning);
    if (!cuts_path.empty()) write_cuts(command, cuts_path, sketch, segmented, options);
    if (options.split_edges) {
      command.warn("edges are split: " + std::to_string(segmented.added_vertices) + " vertices and " +
                   std::to_string(segmented.added_facets) + " facets are added to the mesh's own " +
                   std::to_string(mesh.vertex_count()) + " and " + std::to_string(mesh.facet_count()));
    }
    command.write(document_of(segmented), {&document}, io::segment_metrics(segmented));
  });
}

}  // namespace partwise::segment
