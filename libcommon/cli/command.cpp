#include "cli/command.h"

#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iostream>
#include <iterator>
#include <new>
#include <utility>

#include "cli/arguments.h"
#include "cli/forwarding.h"
#include "error.h"
#include "io/document_kinds.h"
#include "io/pending_file.h"
#include "io/sha256.h"

namespace partwise::cli {
namespace {

constexpr int kComputationFailed = 1;
constexpr int kUsage = 2;
constexpr int kInputOutput = 4;

std::string shown_name(const std::string& path) {
  return path == "-" ? "standard input" : path;
}

std::string expected_kinds(const std::vector<std::string>& kinds) {
  std::string text;
  for (const std::string& name : kinds) {
    const io::DocumentKind* kind = io::find_kind(name);
    text += (text.empty() ? "" : " or ") + name + (kind ? " (made by " + kind->stage + ")" : "");
  }
  return text;
}

}  // namespace

Command::Command(std::string name, std::string synopsis, std::string example)
    : name_(std::move(name)), app_(synopsis, name_) {
  app_.footer("Example:\n  " + example +
              "\n\nDistances are relative to the diagonal of a model's bounding box unless said otherwise.\n"
              "Exit codes: 0 done, 1 computation failed, 2 usage, 3 invalid input, 4 reading or writing.");
  app_.option_defaults()->always_capture_default();
  app_.set_version_flag("--version", name_ + " (partwise) " PARTWISE_VERSION, "Print the version and exit");
  app_.add_flag("-q,--quiet", quiet_, "No warnings and no progress")->group("Common")->capture_default_str();
  app_.add_flag("-v,--verbose", verbose_, "Say what is done")->group("Common");
  app_.add_flag("--profile", profile_, "Add time and peak memory to the metrics (their bytes then differ)")
      ->group("Common");
}

const std::string& Command::input(const std::string& name, const std::string& description, bool optional) {
  std::string& value = inputs_.emplace_back(optional ? "-" : "");
  CLI::Option* option = app_.add_option(name, value, description + (optional ? "; - is standard input" : ""));
  if (!optional) option->required();
  return value;
}

const std::string& Command::output() {
  writes_document_ = true;
  return output_file("Where to write: X.ply (and X.json beside it), or - for standard output");
}

const std::string& Command::output_file(const std::string& description) {
  app_.add_option("-o,--output", output_, description)->group("Common");
  app_.add_flag("-f,--force", force_, "Replace existing output")->group("Common");
  return output_;
}

const bool& Command::certificate() {
  app_.add_flag("--require-certificate", requires_certificate_,
                "Fail (exit code 1) unless the result is certified one-to-one")
      ->group("Common");
  return requires_certificate_;
}

void Command::check_certificate(const std::string& missing) const {
  if (missing.empty()) return;
  const std::string text = "not certified one-to-one: " + missing;
  if (requires_certificate_) throw ComputationError(text);
  warn(text);
}

int Command::parse(int argc, char** argv) {
  try {
    app_.parse(argc, argv);
    return 0;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app_.exit(error, std::cout, std::cerr) == 0 ? -1 : kUsage;
    return report(std::string(error.what()) + "; see " + name_ + " --help", kUsage);
  }
}

void Command::require_document_output() const {
  if (output_ == "-" && ::isatty(STDOUT_FILENO)) {
    throw UsageError("a document is binary and nothing for a terminal: give -o X.ply, or a pipe");
  }
  io::require_writable(output_, force_);
}

int Command::run(int argc, char** argv, const std::function<void()>& body) {
  std::signal(SIGPIPE, SIG_IGN);  // writing then fails, and is reported by its exit code
  try {
    const int outcome = parse(argc, argv);
    if (outcome != 0) return outcome < 0 ? 0 : outcome;
    if (writes_document_) require_document_output();
    body();
    return 0;
  } catch (const BrokenPipe&) {
    return kInputOutput;
  } catch (const InputError& error) {
    // With one input there is no doubt whose fault it is.
    const bool one = files_read_.size() == 1;
    return report(one ? in_file(files_read_[0], error.what()) : error.what(), error.exit_code());
  } catch (const Error& error) {
    return report(error.what(), error.exit_code());
  } catch (const std::bad_alloc&) {
    return report("out of memory: use a smaller model or a larger machine", kComputationFailed);
  } catch (const std::exception& error) {
    return report(std::string("internal error: ") + error.what(), kComputationFailed);
  }
}

int Command::report(const std::string& message, int code) const {
  std::cerr << name_ << ": " << message << std::endl;
  return code;
}

std::string Command::in_file(const std::string& path, const std::string& message) const {
  const std::string prefix = shown_name(path) + ": ";
  return message.compare(0, prefix.size(), prefix) == 0 ? message : prefix + message;
}

void Command::claim_standard_input(const std::string& path) {
  files_read_.push_back(path);
  if (path != "-") return;
  if (standard_input_used_)
    throw UsageError("two inputs cannot both be standard input: give one by its name");
  standard_input_used_ = true;
  if (::isatty(STDIN_FILENO)) {
    throw UsageError("no input: give a file or a pipe; see " + name_ + " --help");
  }
}

io::Document Command::read(const std::string& path, const std::vector<std::string>& kinds) {
  claim_standard_input(path);
  io::Document document = io::read_document(path);
  const std::string kind = document.kind();
  bool expected = kinds.empty();
  for (const std::string& name : kinds) expected = expected || name == kind;
  if (!expected) {
    throw InputError(
        in_file(path, "is a document of kind " + kind + "; expected is " + expected_kinds(kinds)));
  }
  return document;
}

std::string Command::read_text(const std::string& path, const std::string& schema) {
  claim_standard_input(path);
  std::ifstream file;
  if (path != "-") file.open(path, std::ios::binary);
  std::istream& in = path == "-" ? std::cin : file;
  if (!in) throw IoError(path + ": cannot be opened");
  std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (in.bad()) throw IoError(path + ": cannot be read");
  note_input(io::sha256(text), schema);
  return text;
}

io::ImportedMesh Command::import_mesh(const std::string& path) {
  io::ImportedMesh mesh = io::import_mesh(path);
  files_read_.push_back(path);
  std::ifstream file(path, std::ios::binary);
  io::Sha256 hash;
  std::ostream(&hash) << file.rdbuf();
  note_input(hash.hex(), path.substr(path.rfind('.') + 1));
  return mesh;
}

void Command::write_text(const std::string& path, const std::string& text) const {
  const auto put = [&](std::ostream& stream) { stream << text; };
  if (path == "-") {
    io::write_through(path, put);
  } else {
    io::write_file(path, force_, put);
  }
}

void Command::note_input(const std::string& sha256, const std::string& schema) {
  further_inputs_.push_back({{"sha256", sha256}, {"schema", schema}});
}

io::Json Command::arguments() const {
  return given_arguments(app_);
}

io::HistoryEntry Command::history_entry() const {
  return {name_, arguments(), further_inputs_};
}

void Command::write(io::Document document, const std::vector<const io::Document*>& inputs,
                    const io::Json& metrics) {
  write_to(output_, std::move(document), inputs, metrics);
}

void Command::write_to(const std::string& path, io::Document document,
                       const std::vector<const io::Document*>& inputs, const io::Json& metrics) {
  io::Json own = metrics.is_null() ? io::Json::object() : metrics;
  own.update(profile());
  forward_metadata(document.metadata, inputs, name_, own);
  document.metadata["history"] = io::extend_history(inputs, history_entry());
  io::write_document(path, document, force_);
}

io::Json Command::profile() const {
  if (!profile_) return io::Json::object();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start_;
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return {{"profile", {{"seconds", seconds.count()}, {"peak_memory_mb", usage.ru_maxrss / 1024.0}}}};
}

void Command::warn(const std::string& text) const {
  if (!quiet_) std::cerr << name_ << ": warning: " << text << std::endl;
}

void Command::inform(const std::string& text) const {
  if (verbose_ && !quiet_) std::cerr << name_ << ": " << text << std::endl;
}

std::function<void(double)> Command::progress(const std::string& what) const {
  if (quiet_ || !::isatty(STDERR_FILENO)) return [](double) {};
  return [this, what, shown = -1](double fraction) mutable {
    const int percent = static_cast<int>(fraction * 100);
    if (percent == shown) return;
    shown = percent;
    std::cerr << '\r' << name_ << ": " << what << ' ' << percent << " %" << (percent >= 100 ? "\n" : "")
              << std::flush;
  };
}

}  // namespace partwise::cli
