#include <algorithm>
#include <cstring>

#include "cli/command.h"
#include "error.h"
#include "io/sketch.h"
#include "io/stage_documents.h"
#include "segmentation/compatibility.h"
#include "segmentation/segment_mesh.h"

namespace {

using namespace partwise;

constexpr const char* kSynopsis = "Cut a mesh into the parts of a sketch, or check that segmentations match.";
constexpr const char* kExample =
    "segment cat.ply --sketch cat.sketch.json -o cat.segment.ply\n"
    "  segment --check cat.segment.ply lion.segment.ply";

io::Json metrics_of(const SegmentedMesh& segmented) {
  const SegmentedModel& model = segmented.model;
  double snap = 0, concavity = 0;
  for (const Anchor& anchor : model.anchors) snap = std::max(snap, anchor.snap_distance);
  for (const Concavity& part : model.concavity) concavity = std::max(concavity, part.largest);
  return {{"parts", model.segmentation.part_count()},
          {"curves", model.segmentation.curves.size()},
          {"cross_points", model.segmentation.cross_points.size()},
          {"merged_islands", segmented.merged_islands},
          {"removed_pinches", segmented.removed_pinches},
          {"changed_facets", segmented.changed_facets},
          {"largest_snap_distance", snap / model.mesh.diagonal()},
          {"largest_concavity", concavity}};
}

int cut(int argc, char** argv) {
  cli::Command command("segment", kSynopsis, kExample);
  const std::string& input = command.input("mesh", "Mesh document");
  command.output();
  SegmentationOptions options;
  std::string sketch_path, method = "walker";
  bool asks_check = false;  // never set: check() answers
  command.options()
      .add_option("-s,--sketch", sketch_path, "Strokes, markers, anchors; without it the mesh is one part")
      ->type_name("FILE");
  command.options()
      .add_option(
          "--method", method,
          "walker: random walks, boundaries straightened; growth: cheapest step first, as in the paper")
      ->check(CLI::IsMember({"walker", "growth"}));
  command.options()
      .add_option("--tau", options.tau,
                  "Hint to decompose parts whose concavity exceeds this, over the diagonal")
      ->check(CLI::NonNegativeNumber);
  command.options()
      .add_option("--snap-limit", options.snap_limit,
                  "How far points of the sketch may lie from the surface, over the diagonal")
      ->check(CLI::NonNegativeNumber);
  command.options().add_flag("--check", asks_check,
                             "Compare segment documents instead: segment --check A B [C ...]");
  return command.run(argc, argv, [&] {
    const io::Document document = command.read(input, {"mesh"});
    const TriMesh mesh = command.about(input, [&] { return io::read_mesh(document); });
    options.method = method == "growth" ? SegmentationMethod::growth : SegmentationMethod::walker;
    const bool has_sketch = !sketch_path.empty();
    const std::string text = has_sketch ? command.read_text(sketch_path, "partwise/sketch-1") : "";
    const SegmentedMesh segmented = command.about(has_sketch ? sketch_path : input, [&] {
      return segment_mesh(mesh, has_sketch ? io::parse_sketch(text) : Sketch(), options);
    });
    for (const std::string& warning : segmented.warnings) command.warn(warning);
    command.write(io::to_document(segmented.model), {&document}, metrics_of(segmented));
  });
}

int check(int argc, char** argv) {
  cli::Command command("segment", kSynopsis, kExample);
  std::vector<std::string> paths;
  command.options()
      .add_option("--check", paths, "Segment documents; each is compared with the first")
      ->type_name("FILE")
      ->expected(2, 1'000'000);
  return command.run(argc, argv, [&] {
    const SegmentedModel first = io::read_segmented_model(command.read(paths[0], {"segment"}));
    std::string text;
    for (std::size_t i = 1; i < paths.size(); ++i) {
      const SegmentedModel other = io::read_segmented_model(command.read(paths[i], {"segment"}));
      const std::string where = paths[0] + " and " + paths[i] + ": ";
      for (const std::string& difference : compare_segmentations(first, other)) {
        text += (text.empty() ? "" : "\nsegment: ") + where + difference;
      }
      for (const std::string& sentence : misplaced_markers(first, other)) command.warn(where + sentence);
    }
    if (!text.empty()) throw InputError(text + "; change the sketches until the parts match");
  });
}

bool asks_for_check(int argc, char** argv) {
  return std::any_of(argv, argv + argc, [](const char* word) { return std::strcmp(word, "--check") == 0; });
}

}  // namespace

int main(int argc, char** argv) {
  return asks_for_check(argc, argv) ? check(argc, argv) : cut(argc, argv);
}
