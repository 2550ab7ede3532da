#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <utility>

#include "io/document.h"
#include "mesh/types.h"

namespace partwise::sketching {

/// Where the pipeline's files lie.
struct PipelinePlaces {
  std::string makefile;  ///< cross-parameterize.mk
  std::string tools;     ///< folder of the executables
  std::string source, source_sketch;
  std::string target, target_sketch;
  std::string folder;  ///< for the results
};

/// One run at a time of cross-parameterize.mk, as a process group of its own.
class PipelineRun {
 public:
  explicit PipelineRun(PipelinePlaces places) : places_(std::move(places)) {}
  ~PipelineRun();  ///< cancels
  PipelineRun(const PipelineRun&) = delete;
  PipelineRun& operator=(const PipelineRun&) = delete;

  /// Starts, unless it runs; what is up to date is not made again. \throws IoError
  void start();

  /// Ends all its processes; finished documents stay.
  void cancel();

  /// `state` ("idle", "running", "done", "failed", "cancelled"), `stages` with the state of each ("waiting",
  /// "running", "done"), `folder`, `log`: the last lines that make and the tools wrote.
  io::Json state();

  /// \throws InputError unless the run is done
  io::Json measure();

  /// Of the compatible mesh, in the order of the source's vertices. \throws InputError unless the run is done
  Points compatible_points();

 private:
  void reap(bool wait);
  void require_done();
  std::string log() const;
  io::Json stages(const std::string& log) const;

  PipelinePlaces places_;
  std::string state_ = "idle";
  pid_t process_ = 0;
  std::filesystem::file_time_type started_;
};

}  // namespace partwise::sketching
