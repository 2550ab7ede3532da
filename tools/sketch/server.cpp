#include "sketch/server.h"

#include <httplib.h>
#include <signal.h>

#include <thread>

#include "error.h"

namespace partwise::sketching {
namespace {

constexpr const char* kLoopback = "127.0.0.1";
constexpr std::size_t kLargestBody = 64 << 20;  // octets: a sketch of a million points

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
          request.body};
}

}  // namespace

void serve(Requests& requests, int port, const std::function<void(int)>& ready) {
  httplib::Server server;
  server.set_payload_max_length(kLargestBody);
  server.set_default_headers(headers());
  // The library's own would let another process listen on the same port.
  server.set_socket_options([](socket_t) {});
  const auto handle = [&](const httplib::Request& from, httplib::Response& to) {
    Answer answer = requests.answer(request_of(from));
    to.status = answer.status;
    to.set_content(std::move(answer.body), answer.content_type);
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

  sigset_t ending;
  sigemptyset(&ending);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&ending, signal);
  pthread_sigmask(SIG_BLOCK, &ending, nullptr);
  std::thread([&server, ending] {
    int signal = 0;
    sigwait(&ending, &signal);
    server.stop();
  }).detach();
  ready(port);
  server.listen_after_bind();
}

}  // namespace partwise::sketching
