#pragma once

#include <string>
#include <vector>

#include "mapping/domains.h"
#include "measure/sphere_certificate.h"
#include "remeshing/compatible_mesh.h"

namespace partwise {

/// One piece of a map: its two sides on their common sphere.
struct PieceCertificate {
  std::string name;  ///< of its part; of its parts, joined by " + "
  SphereCertificate source;
  SphereCertificate target;
  std::string boundary;  ///< why the boundaries of the two sides do not fit; empty when they do

  bool one_to_one() const { return source.one_to_one() && target.one_to_one() && boundary.empty(); }
  /// Why it is no certificate, one clause; empty when it is.
  std::string reason() const;
};

/// The proof that a map is one-to-one, or what is missing of it.
struct Certificate {
  std::vector<PieceCertificate> pieces;
  std::string reason;  ///< what is wrong of the whole; empty when nothing but pieces can be

  bool one_to_one() const;
  /// What to tell people: the reason, or that of the first piece without certificate.
  std::string first_reason() const;
};

/// Certifies what a document holds from its tables alone; nothing that a stage said of itself is trusted.
///
/// - compatible mesh: every facet of source and target belongs to one chart; on each chart both sides cover
/// the
///   sphere one-to-one, and their boundaries are the same curve, passed once. As charts agree on the edges
///   that they share (see Chart), the pieces together map the whole source one-to-one onto the whole target.
/// - hull maps: every part, capped, covers its hull one-to-one, seen from the hull's centre (both sides of a
///   piece are that part).
/// - cross maps: every part of source and target, capped, covers the target's hull one-to-one, the source's
///   boundary vertices at their places on the target's.
Certificate certify(const CompatibleMesh& mesh);
Certificate certify(const HullMap& map);
Certificate certify(const CrossMap& map);

}  // namespace partwise
