#pragma once

#include <vector>

#include "mesh/types.h"

namespace partwise {

/// How a closed surface around a centre covers the sphere of directions seen from it.
struct HullFolds {
  std::vector<int> folded;  ///< facets that are not positively oriented seen from the centre, ascending
  double degree = 0;  ///< sum of the facets' signed solid angles over 4 pi: how often it covers the sphere

  int count() const { return static_cast<int>(folded.size()); }

  /// Free of folds, and the sphere is covered once: a map can have no fold and yet cover it several times.
  /// For a closed, connected surface of genus 0 this certifies a one-to-one map onto the sphere, and onto
  /// every convex surface around the centre.
  bool one_to_one() const { return folded.empty() && degree > 1 - 1e-3 && degree < 1 + 1e-3; }
};

/// Counts folds by the exact predicate: a facet (p1, p2, p3) is positively oriented when
/// (p1 - c) . ((p2 - p1) x (p3 - p1)) > 0 with `centre` as c.
/// \pre finite coordinates
HullFolds hull_folds(const Points& images, const Facets& facets, const Vec3& centre);

}  // namespace partwise
