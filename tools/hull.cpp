#include "cli/command.h"
#include "io/stage_documents.h"
#include "mapping/build_hulls.h"

namespace {

using namespace partwise;

io::Json metrics_of(const HulledModel& hulled) {
  io::Json parts = io::Json::object();
  for (std::size_t k = 0; k < hulled.hulls.size(); ++k) {
    const ConvexHull& hull = hulled.hulls[k];
    parts[hulled.model.segmentation.names[k]] = {
        {"hull_vertices", hull.points.size()},
        {"hull_facets", hull.facets.size()},
        {"openings", hulled.parts[k].loops.size()},
    };
  }
  return {{"parts", parts}};
}

}  // namespace

int main(int argc, char** argv) {
  cli::Command command("hull", "Wrap the convex hull around every part of a segmented model.",
                       "hull cat.segment.ply -o cat.hull.ply");
  const std::string& input = command.input("model", "Segmented model, as segment writes it");
  command.output();
  return command.run(argc, argv, [&] {
    const io::Document document = command.read(input, {"segment"});
    const HulledModel hulled =
        command.about(input, [&] { return build_hulls(io::read_segmented_model(document)); });
    command.write(io::to_document(hulled), {&document}, metrics_of(hulled));
  });
}
