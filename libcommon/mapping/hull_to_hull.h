#pragma once

#include <string>
#include <vector>

#include "mapping/boundary_correspondence.h"
#include "mapping/domains.h"
#include "mapping/map_by_energy.h"

namespace partwise {

enum class CrossMethod {
  pull,   ///< pulls of growing weight that never turn a facet over
  energy  ///< the paper's energy, which may
};

struct HullToHullOptions {
  CrossMethod method = CrossMethod::pull;
  EnergyMapOptions energy;  ///< for CrossMethod::energy, and for parts whose Q^s has folds
};

/// How one part came onto the target's hull.
struct PartCrossing {
  std::string name;
  int source_folds = 0;  ///< facets of Q^s not positively oriented: 0 is what keeps the result one-to-one
  int folds_before = 0;  ///< of the aligned start with its boundary and markers set in place
  int folds = 0;         ///< of the result
  /// Of these, facets whose three corners lie on the boundary: the target's curve bends the other way there.
  int locked_folds = 0;
  bool one_to_one = false;  ///< certified: genus 0, no folds, degree 1
  double degree = 0;        ///< how often the result covers the hull; 1 for a one-to-one map
  double distortion =
      0;  ///< symmetric Dirichlet against the part, 1 for an isometry; 0 when other folds are left
  int euler_characteristic = 0;               ///< of the source's part with its caps: 2 when it has no handle
  std::vector<std::string> released_markers;  ///< let go because folds remained with them
};

/// Distance of a marker's image from its counterpart's in Q^t, over the target's diagonal.
struct MarkerDistance {
  std::string name;
  double distance = 0;
  bool held = true;  ///< false: only drawn towards its place, see PartCrossing::released_markers
};

struct HullToHull {
  CrossMap map;
  BoundaryCorrespondence boundary;
  std::vector<PartCrossing> parts;      ///< in the target's order
  std::vector<MarkerDistance> markers;  ///< those that constrain a part
  std::vector<std::string> warnings;    ///< for the user, one sentence each
};

/// Maps every part of the source, as it lies on its own hull, onto the target's hull ([Wu11] 5.2): boundary
/// vertices at their arc-length places on the target's boundary, centres of caps on centres of caps, markers
/// on markers.
///
/// Each part is aligned by its fixed points (a linear map about the hulls' centres) and projected centrally,
/// which keeps a one-to-one map one-to-one, then pulled into place without turning a facet over.
/// Differs from [Wu11]: whose energy, Eq. (7-14), folds facets over and meets the boundary nearly; here
/// distortion against the undeformed part is minimised (pin_on_hull) and the boundary met exactly. With
/// CrossMethod::energy, and for a part whose Q^s has folds already, the paper's energy is minimised, the
/// result projected centrally, boundary and markers set in place, and folds undone as far as that succeeds.
///
/// \throws InputError when the models' parts or boundaries do not correspond.
HullToHull map_hull_to_hull(const HullMap& source, const HullMap& target,
                            const HullToHullOptions& options = {});

}  // namespace partwise
