#include <algorithm>
#include <cstring>

#include "segment/modes.h"

namespace {

bool asks_for(const char* option, int argc, char** argv) {
  const std::size_t length = std::strlen(option);
  return std::any_of(argv, argv + argc, [&](const char* word) {
    return std::strncmp(word, option, length) == 0 && (word[length] == 0 || word[length] == '=');
  });
}

}  // namespace

int main(int argc, char** argv) {
  using namespace partwise;
  cli::Command command(
      "segment", "Cut a mesh into the parts of a sketch, or check that segmentations match.",
      "segment cat.ply --sketch cat.sketch.json -o cat.segment.ply\n"
      "  segment cat-02.ply --labels-from cat.segment.ply -o cat-02.segment.ply\n"
      "  segment dog.ply --auto 7 -o dog.sketch.json\n"
      "  segment dog.ply --sketch dog.sketch.json --propose-cuts finer.sketch.json -o dog.segment.ply\n"
      "  segment --check cat.segment.ply lion.segment.ply");
  if (asks_for("--check", argc, argv)) return segment::check(command, argc, argv);
  if (asks_for("--auto", argc, argv)) return segment::suggest(command, argc, argv);
  return segment::cut(command, argc, argv);
}
