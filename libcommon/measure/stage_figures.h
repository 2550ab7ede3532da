#pragma once

#include <map>
#include <optional>
#include <string>

#include "io/document.h"

namespace partwise {

/// Facets of the hull maps that are not positively oriented, over the maps of source and target onto their
/// own hulls and of the source onto the target's hulls.
struct HullFoldCounts {
  int total = 0;
  std::map<std::string, int> parts;
  bool certified = true;  ///< every part of every map is one-to-one by its certificate
};

/// What only the stages could measure, from the metrics they left in the document.
struct StageFigures {
  std::optional<HullFoldCounts> hull_folds;  ///< none unless all three maps have been counted
  std::optional<double> boundary_gap_max;    ///< over the target's diagonal
};

/// Reads the metrics of a compatible mesh: `source.map-to-hull`, `target.map-to-hull` and `hull-to-hull`,
/// each with `parts` (by name, each with its `folds`) and `one_to_one`, whether all parts are certified; and
/// `reconstruct.boundary_gap_max`. Members that are missing or of another type leave their figure undefined.
StageFigures stage_figures(const io::Json& metrics);

}  // namespace partwise
