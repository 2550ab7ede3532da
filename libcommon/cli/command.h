#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <vector>

#include "io/document.h"

namespace partwise::cli {

/// One executable of the pipeline: options, reading, writing, history, messages and exit codes in one place.
///
/// \code
/// int main(int argc, char** argv) {
///   cli::Command command("hull", "Wrap the convex hull around every part.", "hull cat.segment.ply -o
///   cat.hull.ply"); const auto input = command.input("segmented model"); return command.run(argc, argv, [&]
///   {
///     const io::Document document = command.read(*input, "segment");
///     const HulledModel hulled = build_hulls(io::read_segmented_model(document));
///     command.write(io::to_document(hulled), {&document}, metrics);
///   });
/// }
/// \endcode
///
/// Every command has --help, --version, --quiet, --verbose; one that writes a document also -o/--output
/// (default
/// "-") and --force. Options are declared on `options()`; those given by the user go into the history
/// (inputs, output, --force, --quiet, --verbose and --profile do not).
class Command {
 public:
  Command(std::string name, std::string synopsis, std::string example);

  CLI::App& options() { return app_; }

  /// Declares a required positional document; "-" (the default when `optional`) is standard input.
  const std::string& input(const std::string& name, const std::string& description, bool optional = true);

  /// Declares -o/--output and --force.
  const std::string& output();

  /// Parses, runs `body`, turns exceptions into a message on stderr and an exit code.
  int run(int argc, char** argv, const std::function<void()>& body);

  /// Reads a document and checks its kind. \throws InputError that says which stage makes the expected kind.
  io::Document read(const std::string& path, const std::vector<std::string>& kinds) const;

  /// Adds metadata forwarded from the inputs, metrics under the tool's name, history; writes to the output.
  void write(io::Document document, const std::vector<const io::Document*>& inputs,
             const io::Json& metrics = io::Json::object()) const;

  /// A line on stderr unless --quiet: "tool: warning: text".
  void warn(const std::string& text) const;

  /// A line on stderr with --verbose.
  void inform(const std::string& text) const;

 private:
  std::string name_;
  CLI::App app_;
  std::vector<std::string> inputs_;
  std::string output_ = "-";
  bool force_ = false;
  bool quiet_ = false;
  bool verbose_ = false;
};

}  // namespace partwise::cli
