#include "io/sketch.h"
#include "io/stage_documents.h"
#include "segment/modes.h"
#include "segmentation/segment_mesh.h"
#include "segmentation/suggest_sketch.h"

namespace partwise::segment {

void write_sketch(const cli::Command& command, const std::string& path, const Sketch& sketch,
                  const std::string& comment) {
  command.write_text(path, io::to_json(sketch, comment).dump(1) + "\n");
}

int suggest(cli::Command& command, int argc, char** argv) {
  const std::string& input = command.input("mesh", "Mesh document");
  const std::string& output =
      command.output_file("Where to write the sketch, X.sketch.json; - is standard output");
  int part_count = 0;
  command.options()
      .add_option("--auto", part_count, "Number of parts to suggest, the core included")
      ->required()
      ->check(CLI::Range(2, 100));
  return command.run(argc, argv, [&] {
    const TriMesh mesh = command.about(input, [&] { return io::read_mesh(command.read(input, {"mesh"})); });
    const Sketch sketch = command.about(input, [&] {
      Sketch suggestion = suggest_sketch(mesh, part_count);
      segment_mesh(mesh, suggestion, {});  // throws when the suggestion is of no use
      return suggestion;
    });
    write_sketch(command, output, sketch, "a suggestion by segment --auto: to be looked at and corrected");
    command.warn(
        "these parts are a suggestion from far ends of the shape, not a decision: look at them, rename them "
        "as "
        "on the other model, correct the strokes, then segment with --sketch");
  });
}

}  // namespace partwise::segment
