#include "sketching/requests.h"

#include <openssl/crypto.h>
#include <openssl/rand.h>

#include <algorithm>
#include <utility>

#include "error.h"
#include "sketching/background.h"

namespace partwise::sketching {
namespace {

using io::Json;

constexpr std::size_t kLargestPlace = 1000;  // octets

Answer json(const Json& value) {
  return {200, "application/json", value.dump(-1, ' ', false, Json::error_handler_t::replace)};
}

Answer octets(std::string body) {
  return {200, "application/octet-stream", std::move(body)};
}

Answer error(int status, const std::string& sentence) {
  Answer answer = json({{"error", sentence}});
  answer.status = status;
  return answer;
}

Answer not_found() {
  return error(404, "there is nothing at this address");
}

Answer wrong_method() {
  return error(405, "this address does not know that method");
}

bool changes_something(const std::string& method) {
  return method != "GET" && method != "HEAD";
}

// In a time that does not tell how much was right.
bool equal_secrets(const std::string& a, const std::string& b) {
  return a.size() == b.size() && CRYPTO_memcmp(a.data(), b.data(), a.size()) == 0;
}

}  // namespace

Requests::Requests(std::string token, std::string page, std::vector<std::unique_ptr<SketchedModel>> models,
                   std::unique_ptr<PipelineRun> run)
    : token_(std::move(token)), page_(std::move(page)), models_(std::move(models)), run_(std::move(run)) {}

std::optional<Answer> Requests::refusal(const Request& request) const {
  if (std::find(hosts_.begin(), hosts_.end(), request.host) == hosts_.end()) {
    return error(403, "this host is not the server's");
  }
  const std::string start = "/" + token_ + "/";
  if (!equal_secrets(request.path.substr(0, start.size()), start)) {
    return error(403, "the address must begin with the token that sketch printed");
  }
  if (!request.origin.empty() && request.origin != "http://" + request.host) {
    return error(403, "requests of other pages are not answered");
  }
  if (!changes_something(request.method)) return {};
  if (request.origin.empty()) return error(403, "changes must name their origin");
  if (request.content_type.substr(0, request.content_type.find(';')) != "application/json") {
    return error(415, "changes must be application/json");
  }
  if (!request.is_plain) return error(411, "changes must say their length, and not be compressed");
  return {};
}

Answer Requests::answer(const Request& request) {
  if (std::optional<Answer> refused = refusal(request)) return *refused;
  Request inner = request;
  inner.path = request.path.substr(token_.size() + 2);
  try {
    if (std::optional<Answer> found = slow(inner)) return *found;
    const std::lock_guard<std::mutex> lock(mutex_);
    return routed(inner);
  } catch (const InputError& wrong) {
    return error(400, wrong.what());
  } catch (const std::exception& failure) {
    return error(500, failure.what());
  }
}

// What takes long, computed from what was there when it was asked for.
std::optional<Answer> Requests::slow(const Request& request) {
  for (std::size_t i = 0; i < models_.size(); ++i) {
    const std::string prefix = "models/" + std::to_string(i) + "/";
    if (request.path == prefix + "hints") return hints_of(request, *models_[i]);
    if (request.path == prefix + "mirror") return mirror_of(request, *models_[i]);
  }
  return {};
}

Answer Requests::hints_of(const Request& request, const SketchedModel& model) {
  if (changes_something(request.method)) return wrong_method();
  std::shared_ptr<const SegmentedModel> segmented;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    segmented = model.segmented();
  }
  Json found = {{"concave", Json::array()}, {"proposed_cuts", Json::array()}};
  if (segmented) in_background([&] { found = hints(*segmented); });
  return json(found);
}

// A place is sent as what changes something is, though it changes nothing: it has a body.
Answer Requests::mirror_of(const Request& request, SketchedModel& model) {
  if (!changes_something(request.method)) {
    Json facts;
    in_background([&] { facts = model.mirror().facts(); });
    return json(facts);
  }
  if (request.method != "POST") return wrong_method();
  if (request.body.size() > kLargestPlace) return error(413, "that is too large for a place");
  return json(model.mirrored(request.body));
}

Answer Requests::routed(const Request& request) {
  const std::string& path = request.path;
  if (path.rfind("run", 0) == 0) return of_run(request, path.substr(3));
  for (std::size_t i = 0; i < models_.size(); ++i) {
    const std::string prefix = "models/" + std::to_string(i) + "/";
    if (path.rfind(prefix, 0) == 0) return of_model(request, *models_[i], path.substr(prefix.size()));
  }
  if (!path.empty() && path != "models" && path != "check") return not_found();
  if (changes_something(request.method)) return wrong_method();
  if (path.empty()) return {200, "text/html; charset=utf-8", page_};
  if (path == "check") {
    return json(models_.size() == 2 ? compare(*models_[0], *models_[1])
                                    : Json{{"problem", "there is one model only"}});
  }
  Json facts = Json::array();
  for (const auto& model : models_) facts.push_back(model->facts());
  return json({{"models", facts}});
}

Answer Requests::of_model(const Request& request, SketchedModel& model, const std::string& what) {
  if (what == "sketch" && request.method == "PUT") {
    model.put(request.body);
    return json(model.result());
  }
  if (what != "sketch" && what != "result" && what != "mesh") return not_found();
  if (changes_something(request.method)) return wrong_method();
  if (what == "mesh") return octets(model.geometry());
  return json(what == "sketch" ? model.sketch() : model.result());
}

Answer Requests::of_run(const Request& request, const std::string& what) {
  if (!run_) return error(404, "the pipeline needs two models");
  if (what.empty()) {
    if (request.method == "POST") {
      for (const auto& model : models_) {
        if (!model->has_saved_sketch()) model->put(model->sketch().dump());
      }
      run_->start();
    } else if (request.method == "DELETE") {
      run_->cancel();
    } else if (changes_something(request.method)) {
      return wrong_method();
    }
    return json(run_->state());
  }
  if (what != "/mesh" && what != "/measure") return not_found();
  if (changes_something(request.method)) return wrong_method();
  if (what == "/measure") return json(run_->measure());
  return octets(models_[1]->normalized(run_->compatible_points()));
}

std::string random_token(int octets) {
  std::vector<unsigned char> random(octets);
  if (RAND_bytes(random.data(), octets) != 1) throw IoError("the operating system gives no random numbers");
  std::string token;
  for (const unsigned char octet : random) {
    for (const int digit : {octet >> 4, octet & 15}) token.push_back("0123456789abcdef"[digit]);
  }
  return token;
}

}  // namespace partwise::sketching
