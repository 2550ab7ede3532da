#pragma once

#include <CLI/CLI.hpp>

#include <chrono>
#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "error.h"
#include "io/document.h"
#include "io/mesh_files.h"

namespace partwise::cli {

/// One executable of the pipeline: options, reading, writing, history, messages and exit codes in one place.
///
/// \code
/// int main(int argc, char** argv) {
///   cli::Command command("hull", "Wrap the convex hull around every part.",
///                        "hull cat.segment.ply -o cat.hull.ply");
///   const std::string& input = command.input("model", "segmented model");
///   command.output();
///   return command.run(argc, argv, [&] {
///     const io::Document document = command.read(input, {"segment"});
///     const HulledModel hulled = build_hulls(io::read_segmented_model(document));
///     command.write(io::to_document(hulled), {&document}, {{"hulls", hulled.hulls.size()}});
///   });
/// }
/// \endcode
///
/// Every command has --help, --version, --quiet, --verbose and --profile; one that writes a document also
/// -o/--output (default "-") and --force. Options are declared on `options()`, with their units in the
/// description; those that the user gives with another value than the default go into the history, but for
/// files (type name FILE or PATH, as the checks CLI::ExistingFile and so on set it) and the common ones.
class Command {
 public:
  Command(std::string name, std::string synopsis, std::string example);

  CLI::App& options() { return app_; }

  /// Declares a positional file; "-" (the default when `optional`) is standard input. The reference holds the
  /// user's value once `run` has parsed, and stays valid.
  const std::string& input(const std::string& name, const std::string& description, bool optional = true);

  /// Declares -o/--output and --force, for documents: a path ending in .ply, or "-".
  const std::string& output();

  /// The same for another kind of output, which the tool writes itself (io::write_file with `force()`).
  const std::string& output_file(const std::string& description);
  bool force() const { return force_; }

  /// Declares --require-certificate; the reference holds whether it was given once `run` has parsed.
  const bool& certificate();

  /// With --require-certificate, fails with what is `missing` of the certificate that the result is
  /// one-to-one (empty: nothing); without, warns. \throws ComputationError
  void check_certificate(const std::string& missing) const;

  /// What `run` checks before `body` for a command that declared `output()`. \throws UsageError, IoError
  void require_document_output() const;

  /// Parses, runs `body`, turns exceptions into a message on stderr and an exit code: 0 done, 1 computation
  /// failed, 2 usage, 3 input, 4 reading or writing.
  int run(int argc, char** argv, const std::function<void()>& body);

  /// Reads a document and checks its kind ({} for any).
  /// \throws InputError that says which stage makes the expected kind.
  io::Document read(const std::string& path, const std::vector<std::string>& kinds);

  /// Runs `use`; InputErrors that it throws name the file `path` in front.
  template <class Use>
  auto about(const std::string& path, Use&& use) const {
    try {
      return use();
    } catch (const InputError& error) {
      throw InputError(in_file(path, error.what()));
    }
  }

  /// Reads a text file (a sketch) whole and notes it as an input for the history. "-" is standard input.
  std::string read_text(const std::string& path, const std::string& schema);

  /// Imports a mesh of another program (io::import_mesh) and notes it as an input for the history.
  io::ImportedMesh import_mesh(const std::string& path);

  /// Writes a text whole or not at all, to a file (an existing one only with --force) or, "-", to standard
  /// output; for what a tool makes beside or instead of a document. \throws IoError
  void write_text(const std::string& path, const std::string& text) const;

  /// Notes an input that is no document, for the history.
  void note_input(const std::string& sha256, const std::string& schema);

  /// What this run adds to the history of what it makes; for tools whose output is no io::Document.
  io::HistoryEntry history_entry() const;

  /// Adds unknown metadata forwarded from the inputs, metrics under the tool's name, history; writes to the
  /// output. Of two inputs the first is the source, the second the target.
  void write(io::Document document, const std::vector<const io::Document*>& inputs,
             const io::Json& metrics = io::Json::object());

  /// The same for a tool that writes several documents, to a path of its own choice.
  void write_to(const std::string& path, io::Document document,
                const std::vector<const io::Document*>& inputs, const io::Json& metrics = io::Json::object());

  /// Time and peak memory with --profile, else nothing; `write` adds it to a document's metrics itself.
  io::Json profile() const;

  /// A line on stderr unless --quiet: "tool: warning: text".
  void warn(const std::string& text) const;

  /// A line on stderr with --verbose.
  void inform(const std::string& text) const;

  /// For long work: shows "tool: <what> 42 %" when stderr is a terminal, unless --quiet.
  std::function<void(double fraction)> progress(const std::string& what) const;

 private:
  int parse(int argc, char** argv);
  void claim_standard_input(const std::string& path);
  io::Json arguments() const;
  std::string in_file(const std::string& path, const std::string& message) const;
  int report(const std::string& message, int code) const;

  std::string name_;
  CLI::App app_;
  std::deque<std::string> inputs_;
  std::string output_ = "-";
  bool writes_document_ = false;
  bool force_ = false;
  bool requires_certificate_ = false;
  bool quiet_ = false;
  bool verbose_ = false;
  bool profile_ = false;
  bool standard_input_used_ = false;
  std::vector<std::string> files_read_;
  io::Json further_inputs_ = io::Json::array();
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace partwise::cli
