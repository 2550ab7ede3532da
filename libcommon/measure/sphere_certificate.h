#pragma once

#include <string>

#include "mesh/types.h"

namespace partwise {

/// Whether a closed surface, every vertex with a direction, covers the sphere of directions one-to-one.
struct SphereCertificate {
  int facets = 0;
  int euler_characteristic = 0;
  int folds = 0;       ///< facets not positively oriented seen from the centre
  int degree = 0;      ///< facets behind one generic direction; only counted without folds
  std::string reason;  ///< why it is none, one clause; empty when it is a certificate

  bool one_to_one() const { return reason.empty(); }
};

/// Checks, by exact predicates and counting alone, that (1) every edge has two facets, in opposite
/// directions, the facets around every vertex form one fan, all are connected, and V - E + F = 2: the surface
/// is a sphere; (2) every facet is positively oriented as seen from the origin; (3) one direction in general
/// position meets exactly one facet. By (1) and (2) the map covers the sphere equally often everywhere,
/// branching at vertices at most (z -> z^2 has no fold); by (3) once.
///
/// No code is shared with the stages that make such maps. Directions may have any length > 0.
/// \pre facets name entries of `directions`, which are finite; every entry is named
SphereCertificate certify_sphere(const Facets& facets, const Points& directions);

}  // namespace partwise
