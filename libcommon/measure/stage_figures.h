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
  bool one_to_one = false;                   ///< the last stage that moved vertices certifies the whole map
};

/// Reads the metrics of a compatible mesh: `source.map-to-hull`, `target.map-to-hull` and `hull-to-hull`,
/// each with `hull_folds.parts` (folds by the part's name) or `parts` (an array of objects with `name` and
/// `folds`), and `one_to_one`, whether the whole map is certified; `reconstruct.boundary_gap_max`; and
/// `one_to_one` of `relocate` or else `reconstruct`. Members that are missing or of another type leave their
/// figure undefined.
StageFigures stage_figures(const io::Json& metrics);

}  // namespace partwise
