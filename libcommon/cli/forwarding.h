#pragma once

#include <string>
#include <vector>

#include "io/document.h"

namespace partwise::cli {

/// Adds to `metadata` what the inputs know and the stage does not: unknown fields and earlier metrics.
///
/// One input: its fields and metrics stay where they are, unless the stage wrote fields of that name. Two:
/// fields that are equal in both stay; others go to "inputs", and metrics to "metrics", under "source" and
/// "target". The stage's own metrics go under the tool's name.
void forward_metadata(io::Json& metadata, const std::vector<const io::Document*>& inputs,
                      const std::string& tool, const io::Json& metrics);

}  // namespace partwise::cli
