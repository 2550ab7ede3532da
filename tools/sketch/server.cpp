#include "sketch/server.h"

#include <fcntl.h>
#include <httplib.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <memory>
#include <thread>
#include <utility>

#include "error.h"

namespace partwise::sketching {
namespace {

constexpr const char* kLoopback = "127.0.0.1";
constexpr std::size_t kLargestBody = 64 << 20;  // octets: a sketch of a million points
constexpr std::time_t kLongestPause = 1;  // seconds within a request; the server's end waits for it, too

// Pages of this server are to run by themselves, in no frame, and to tell nobody of their address.
const httplib::Headers& headers() {
  static const httplib::Headers headers{{"Cache-Control", "no-store"},
                                        {"Cross-Origin-Opener-Policy", "same-origin"},
                                        {"Cross-Origin-Resource-Policy", "same-origin"},
                                        {"Referrer-Policy", "no-referrer"},
                                        {"X-Content-Type-Options", "nosniff"},
                                        {"X-Frame-Options", "DENY"}};
  return headers;
}

Request request_of(const httplib::Request& request) {
  return {request.method,
          request.path,
          request.get_header_value("Host"),
          request.get_header_value("Origin"),
          request.get_header_value("Content-Type"),
          !request.has_header("Transfer-Encoding") && !request.has_header("Content-Encoding"),
          request.body};
}

/// Sends the body as it is: the library would compress it, which takes far longer than the loopback does.
void set_answer(Answer answer, httplib::Response& to) {
  to.status = answer.status;
  if (answer.body.empty()) return to.set_content("", answer.content_type);
  const auto body = std::make_shared<const std::string>(std::move(answer.body));
  to.set_content_provider(body->size(), answer.content_type,
                          [body](std::size_t from, std::size_t count, httplib::DataSink& sink) {
                            return sink.write(body->data() + from, count);
                          });
}

/// Waits for SIGINT, SIGTERM or SIGHUP, whichever thread they reach. Not by a mask: threads that run already
/// would not have it, and processes that are started would.
class EndingSignals {
 public:
  EndingSignals() {
    if (pipe2(pipe_, O_CLOEXEC) != 0) throw IoError("no pipe can be made");
    struct sigaction action = {};
    action.sa_handler = [](int) {
      const char octet = 0;
      [[maybe_unused]] const auto ignored = write(pipe_[1], &octet, 1);
    };
    action.sa_flags = SA_RESTART;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
  }

  void wait() const {
    char octet = 0;
    while (read(pipe_[0], &octet, 1) < 0 && errno == EINTR) {
    }
  }

 private:
  static inline int pipe_[2] = {-1, -1};  // what a handler can reach
};

}  // namespace

void serve(Requests& requests, int port, const std::function<void(int)>& ready) {
  httplib::Server server;
  server.set_payload_max_length(kLargestBody);
  server.set_read_timeout(kLongestPause);
  server.set_default_headers(headers());
  // The library's own would let another process listen on the same port.
  server.set_socket_options([](socket_t) {});
  // The body of a refused request is not read, so what follows on its connection is no request.
  server.set_keep_alive_max_count(1);
  server.set_pre_routing_handler([&](const httplib::Request& from, httplib::Response& to) {
    std::optional<Answer> refused = requests.refusal(request_of(from));
    if (!refused) return httplib::Server::HandlerResponse::Unhandled;
    set_answer(std::move(*refused), to);
    return httplib::Server::HandlerResponse::Handled;
  });
  const auto handle = [&](const httplib::Request& from, httplib::Response& to) {
    set_answer(requests.answer(request_of(from)), to);
  };
  const std::string any = ".*";
  server.Get(any, handle).Put(any, handle).Post(any, handle).Delete(any, handle);

  if (port == 0) {
    port = server.bind_to_any_port(kLoopback);
    if (port < 0) throw IoError("no port of 127.0.0.1 is free");
  } else if (!server.bind_to_port(kLoopback, port)) {
    throw IoError("port " + std::to_string(port) +
                  " of 127.0.0.1 is taken; choose another, or leave out --port");
  }
  requests.set_hosts({kLoopback + (":" + std::to_string(port)), "localhost:" + std::to_string(port)});

  EndingSignals signals;
  std::thread([&] {
    signals.wait();
    server.stop();
  }).detach();
  ready(port);
  server.listen_after_bind();
}

}  // namespace partwise::sketching
