#pragma once

#include <string>
#include <vector>

#include "report/panel.h"

namespace partwise::report {

struct SceneOptions {
  int columns = 4;   ///< panels side by side, then the next row
  int width = 1600;  ///< of the picture, pixels
};

/// A scene for POV-Ray 3.7: the panels row by row, each fitted into its cell with its caption below, seen
/// orthographically in neutral light. The first line is a comment with the size that `povray` must be called
/// with:
/// "// +W1600 +H700".
/// \throws InputError when a panel has no facets; UsageError when there are no panels or no columns.
std::string pov_scene(const std::vector<Panel>& panels, const SceneOptions& options);

}  // namespace partwise::report
