#include <ostream>

#include "cli/command.h"
#include "io/document_summary.h"
#include "io/pending_file.h"

using namespace partwise;

int main(int argc, char** argv) {
  cli::Command command("document", "Show what a document contains and how it came to be, or check it.",
                       "document --check cat.hullmap.ply");
  const std::string& input = command.input("document", "Document of any kind");
  bool check = false, json = false;
  CLI::Option* check_option = command.options().add_flag(
      "--check", check,
      "Print nothing, but fail when the document is damaged: checksums, schema, and every table against "
      "the others");
  command.options().add_flag("--json", json, "Print the metadata as JSON")->excludes(check_option);
  return command.run(argc, argv, [&] {
    const io::Document document = command.read(input, {});
    if (check) return command.about(input, [&] { io::check_document(document); });
    const std::string text = json ? document.metadata.dump(2) + "\n" : io::summary(document);
    io::write_through("-", [&](std::ostream& out) { out << text; });
  });
}
