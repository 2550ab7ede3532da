#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "sketching/pipeline_run.h"
#include "sketching/sketched_model.h"

namespace partwise::sketching {

/// What of an HTTP request decides its answer.
struct Request {
  std::string method;
  std::string path;  ///< decoded, without the query
  std::string host;
  std::string origin;  ///< empty when there is none
  std::string content_type;
  bool is_plain = true;  ///< its body is neither compressed nor in chunks, so that its head tells its size
  std::string body;
};

struct Answer {
  int status = 200;
  std::string content_type = "application/json";
  std::string body;
};

/// The page's requests and their answers, apart from sockets.
///
/// Only paths below "/<token>/" are answered, only for a Host that is the server's own address (a page of
/// another site cannot reach in by a name that it lets point here), and what changes something only from the
/// page itself (Origin) and as JSON whose size is known beforehand. No path or file name comes from a
/// request. Threads may share it: answers follow one another, but for hints and mirrored places,
/// which keep no stroke waiting.
///
/// Below the token: the page; `models`, the facts of each; of model N, `models/N/sketch` (GET, PUT),
/// `result`, `mesh`, `hints` (GET), and `mirror`: GET says how symmetric it is, POST of a marker's place
/// (SketchedModel
/// ::mirrored, at most 1,000 octets) gives the mirrored place; `check`, whether two models agree; `run` (GET,
/// POST to start, DELETE to cancel), `run/mesh`, `run/measure`.
class Requests {
 public:
  /// \param token what the page's address must begin with \pre not empty
  /// \param page its HTML
  /// \param models one or two \param run the pipeline from the first to the second; null with one model
  Requests(std::string token, std::string page, std::vector<std::unique_ptr<SketchedModel>> models,
           std::unique_ptr<PipelineRun> run);

  /// The hosts that requests may name, such as "127.0.0.1:8080"; none before this is called.
  void set_hosts(std::vector<std::string> hosts) { hosts_ = std::move(hosts); }

  /// Why a request may not be answered, from its head alone (its body need not be there yet); none when it
  /// may. Waits for nothing.
  std::optional<Answer> refusal(const Request& request) const;

  /// Never throws for what a request contains: errors are answers with a status of 400 and more, those of
  /// refusal() first.
  Answer answer(const Request& request);

 private:
  Answer routed(const Request& request);
  std::optional<Answer> slow(const Request& request);
  Answer hints_of(const Request& request, const SketchedModel& model);
  static Answer mirror_of(const Request& request, SketchedModel& model);
  Answer of_model(const Request& request, SketchedModel& model, const std::string& what);
  Answer of_run(const Request& request, const std::string& what);

  std::string token_;
  std::string page_;
  std::vector<std::unique_ptr<SketchedModel>> models_;
  std::unique_ptr<PipelineRun> run_;
  std::vector<std::string> hosts_;
  std::mutex mutex_;
};

/// So many random octets of the operating system, as hexadecimal digits. \throws IoError
std::string random_token(int octets);

}  // namespace partwise::sketching
