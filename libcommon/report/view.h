#pragma once

#include <string>

#include "mesh/types.h"

namespace partwise::report {

/// Where an orthographic picture looks from: three orthonormal directions in the model's coordinates.
struct View {
  Vec3 right = Vec3::UnitX();
  Vec3 up = Vec3::UnitY();
  Vec3 toward = Vec3::UnitZ();  ///< from the model towards the eye

  /// (right, up, toward) coordinates of a point or direction.
  Vec3 apply(const Vec3& p) const { return {right.dot(p), up.dot(p), toward.dot(p)}; }
};

/// Looks at the model from `toward`, with `up` as nearly upwards as this allows.
/// \throws InputError when the two are parallel or one is zero.
View view_from(const Vec3& toward, const Vec3& up);

/// Six numbers "toward.x,toward.y,toward.z,up.x,up.y,up.z". \throws UsageError when `text` is something else.
View parse_view(const std::string& text);

/// A side view of a standing body, turned a little: along the axis of its smallest extent, on its feet.
///
/// A guess: up is the direction opposite to which the outermost slices spread widest, as feet do; y when in
/// doubt. \pre points is not empty
View automatic_view(const Points& points);

}  // namespace partwise::report
