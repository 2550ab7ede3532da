#pragma once

#include <functional>
#include <string>

#include "sketching/requests.h"

namespace partwise::sketching {

/// Answers HTTP requests on 127.0.0.1, and on no other address, until the process is asked to end (SIGINT,
/// SIGTERM). \param port 0 for any that is free \param ready called with the port once requests are accepted
/// \throws IoError when the port is taken
void serve(Requests& requests, int port, const std::function<void(int port)>& ready);

}  // namespace partwise::sketching
