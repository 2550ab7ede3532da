#include "error.h"
#include "io/stage_documents.h"
#include "segment/modes.h"
#include "segmentation/compatibility.h"

namespace partwise::segment {

int check(cli::Command& command, int argc, char** argv) {
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

}  // namespace partwise::segment
