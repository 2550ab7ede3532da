#pragma once

#include <string>
#include <vector>

#include "mapping/map_by_energy.h"

namespace partwise {

enum class HullMapMethod {
  progressive,  ///< map_progressively
  lifted,       ///< map_by_lifting
  energy        ///< map_by_energy
};

struct MapToHullOptions {
  HullMapMethod method = HullMapMethod::progressive;
  EnergyMapOptions energy;  ///< for HullMapMethod::energy, and for parts that the other cannot map
};

/// How good the map of one part is.
struct PartMapReport {
  HullMapMethod method = HullMapMethod::progressive;  ///< the one that made this map
  std::string remark;                                 ///< why it is not the method asked for, or empty
  int facets = 0;                                     ///< of the part with its caps
  int folds_before = 0;                               ///< energy: folded facets before their repair
  int folds = 0;                 ///< facets not positively oriented, seen from the hull's centre
  int euler_characteristic = 0;  ///< of the part with its caps: 2 when it has no handle
  double degree = 0;             ///< how often the map covers the hull
  bool one_to_one = false;       ///< certified: genus 0, no folds, degree 1
  double distortion = 0;         ///< progressive: symmetric Dirichlet, 1 for an isometry; else 0
  double off_hull = 0;  ///< energy: largest distance to the hull before projection, over the part's diagonal
};

struct MappedToHull {
  HullMap map;
  std::vector<PartMapReport> reports;  ///< one per part
};

/// Maps every capped part onto its own convex hull ([Wu11] 5.1): by the paper's energy (see map_by_energy),
/// or progressively (see map_progressively), which is one-to-one for every part of genus 0.
///
/// A part that the progressive method cannot map in double precision is mapped by lifting (map_by_lifting);
/// if that cannot either, or the part has a handle, by the energy; its report says so. All images lie on the
/// hull within rounding. \throws ComputationError naming the part
MappedToHull map_to_hull(const HulledModel& hulled, const MapToHullOptions& options = {});

}  // namespace partwise
