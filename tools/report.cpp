#include <string>

#include "cli/command.h"
#include "io/pending_file.h"
#include "report/batch_page.h"
#include "report/run_page.h"

using namespace partwise;

namespace {

struct Options {
  std::string source;
  std::string target;
  bool index = false;
  report::RunPageOptions run;
  report::BatchPageOptions batch;
};

void declare(CLI::App& app, Options& options) {
  app.add_option("--source-model", options.source,
                 "Documents of the source, X for X.segment.ply and so on; by default FOLDER/source, or the "
                 "model of batch.mk")
      ->type_name("PREFIX");
  app.add_option("--target-model", options.target, "Documents of the target, likewise")->type_name("PREFIX");
  app.add_flag("--index", options.index,
               "FOLDER holds many pairs (batch.mk): a table of all, which links to FOLDER/PAIR/report.html");
  app.add_option(
         "--facets", options.run.most_facets,
         "Facets of each model to show; larger models are decimated for display, and the page says so")
      ->check(CLI::PositiveNumber);
  app.add_option("--thumbnail-facets", options.batch.thumbnail_facets, "The same for thumbnails of --index")
      ->check(CLI::PositiveNumber);
}

std::string page(cli::Command& command, const std::string& folder, const Options& options) {
  if (options.index) return report::batch_page(folder, options.batch);
  report::RunPlaces places = report::run_places(folder);
  if (!options.source.empty()) places.source = options.source;
  if (!options.target.empty()) places.target = options.target;
  const report::RunDocuments run = command.about(folder, [&] { return report::read_run(places); });
  for (const report::StageState& stage : run.stages) {
    if (!stage.trouble.empty()) command.warn(stage.title + ": " + stage.file + ": " + stage.trouble);
  }
  return report::run_page(run, options.run);
}

}  // namespace

int main(int argc, char** argv) {
  cli::Command command("report", "Show a finished pair, or a batch of them, as one HTML page to look at.",
                       "report cat-lion -o cat-lion/report.html");
  Options options;
  const std::string& folder =
      command.input("folder", "Folder of a pair that cross-parameterize.mk made", false);
  declare(command.options(), options);
  const std::string& output = command.output_file("Where to write the page, X.html; - is standard output");
  return command.run(argc, argv, [&] { command.write_text(output, page(command, folder, options)); });
}
