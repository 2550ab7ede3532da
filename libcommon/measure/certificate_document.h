#pragma once

#include <string>

#include "io/document.h"
#include "measure/certificate.h"

namespace partwise {

/// The member `certificate` of partwise/measure-1: `one_to_one`, `pieces` with both sides' counts, and the
/// `reason` when there is no certificate.
io::Json certificate_json(const Certificate& certificate);

/// The same as lines of text: the verdict about `name`, then a line per piece.
std::string certificate_text(const std::string& name, const Certificate& certificate);

}  // namespace partwise
