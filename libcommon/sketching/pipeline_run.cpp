#include "sketching/pipeline_run.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <thread>
#include <vector>

#include "error.h"
#include "io/stage_documents.h"

namespace partwise::sketching {
namespace {

using io::Json;

constexpr std::size_t kLogShown = 4000;  // octets
constexpr int kPatience = 2000;          // milliseconds

struct Stage {
  const char* name;
  const char* file;
};

constexpr std::array<Stage, 11> kStages{{{"segment source", "source.segment.ply"},
                                         {"segment target", "target.segment.ply"},
                                         {"hull source", "source.hull.ply"},
                                         {"hull target", "target.hull.ply"},
                                         {"map-to-hull source", "source.hullmap.ply"},
                                         {"map-to-hull target", "target.hullmap.ply"},
                                         {"hull-to-hull", "crossmap.ply"},
                                         {"reconstruct", "reconstructed.ply"},
                                         {"critical-points", "critical.ply"},
                                         {"relocate", "compatible.ply"},
                                         {"measure", "measure.json"}}};

std::string in_folder(const std::string& folder, const std::string& file) {
  return (std::filesystem::path(folder) / file).string();
}

/// Waits for what make leaves of a process group that was asked to end, then insists.
void end_group(pid_t group) {
  for (int i = 0; i < kPatience && kill(-group, 0) == 0; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  kill(-group, SIGKILL);
}

}  // namespace

PipelineRun::~PipelineRun() {
  cancel();
}

void PipelineRun::start() {
  reap(false);
  if (process_ != 0) return;
  std::error_code error;
  std::filesystem::create_directories(places_.folder, error);
  if (error) throw IoError(places_.folder + ": cannot make the folder for results: " + error.message());
  std::vector<std::string> words{"make",
                                 "--no-print-directory",
                                 "-j2",
                                 "-f",
                                 places_.makefile,
                                 "PARTWISE_BIN=" + places_.tools,
                                 "SOURCE=" + places_.source,
                                 "SOURCE_SKETCH=" + places_.source_sketch,
                                 "TARGET=" + places_.target,
                                 "TARGET_SKETCH=" + places_.target_sketch,
                                 "OUT=" + places_.folder};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);

  started_ = std::filesystem::file_time_type::clock::now();
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, in_folder(places_.folder, "run.log").c_str(),
                                   O_WRONLY | O_CREAT | O_TRUNC, 0666);
  posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  // Whatever signals are blocked here: cancel() must reach it.
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
  const int failure = posix_spawnp(&process_, "make", &files, &attributes, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  posix_spawnattr_destroy(&attributes);
  if (failure != 0) {
    process_ = 0;
    throw IoError(std::string("cannot run make: ") + std::strerror(failure) + "; install GNU make");
  }
  state_ = "running";
}

void PipelineRun::cancel() {
  reap(false);
  if (process_ == 0) return;
  const pid_t group = process_;
  kill(-group, SIGTERM);
  reap(true);
  end_group(group);
  state_ = "cancelled";
}

void PipelineRun::reap(bool wait) {
  if (process_ == 0) return;
  int status = 0;
  if (waitpid(process_, &status, wait ? 0 : WNOHANG) != process_) return;
  process_ = 0;
  state_ = WIFEXITED(status) && WEXITSTATUS(status) == 0 ? "done" : "failed";
}

std::string PipelineRun::log() const {
  std::ifstream in(in_folder(places_.folder, "run.log"), std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// A stage runs once make has shown its command, and is done once its file has its name after that; one that
// is up to date is neither.
io::Json PipelineRun::stages(const std::string& log) const {
  namespace fs = std::filesystem;
  Json result = Json::array();
  std::error_code error;
  for (const auto& [name, file] : kStages) {
    const std::string path = in_folder(places_.folder, file);
    const bool there = fs::exists(path, error);
    const bool shown = log.find("-o " + path) != std::string::npos;
    const bool made = there && shown && fs::last_write_time(path, error) >= started_;
    const char* state = state_ == "done" || made       ? "done"
                        : shown && state_ == "running" ? "running"
                                                       : "waiting";
    result.push_back({{"name", name}, {"state", state}});
  }
  return result;
}

io::Json PipelineRun::state() {
  reap(false);
  if (state_ == "idle") return {{"state", state_}, {"stages", Json::array()}, {"log", ""}};
  const std::string text = log();
  return {{"state", state_},
          {"stages", stages(text)},
          {"folder", places_.folder},
          {"log", text.size() > kLogShown ? text.substr(text.size() - kLogShown) : text}};
}

void PipelineRun::require_done() {
  reap(false);
  if (state_ != "done") throw InputError("there is no finished run");
}

io::Json PipelineRun::measure() {
  require_done();
  std::ifstream in(in_folder(places_.folder, "measure.json"));
  return Json::parse(in);
}

Points PipelineRun::compatible_points() {
  require_done();
  return io::read_mesh(io::read_document(in_folder(places_.folder, "compatible.ply"))).points();
}

}  // namespace partwise::sketching
