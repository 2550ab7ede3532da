#pragma once

#include <CLI/CLI.hpp>

#include "io/document.h"

namespace partwise::cli {

/// The options that were given, option -> value, without defaults, files and the group "Common".
///
/// Flags are true, numbers numbers (0.30 and 0.3 are the same), repeated options arrays.
io::Json given_arguments(const CLI::App& app);

}  // namespace partwise::cli
