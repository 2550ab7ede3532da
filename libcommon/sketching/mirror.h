#pragma once

#include <optional>
#include <string>

#include "geometry/surface_index.h"
#include "io/document.h"
#include "sketching/mirror_plane.h"

namespace partwise::sketching {

/// Suggests where the other one of a pair of markers lies: the place mirrored about the model's plane of
/// symmetry. Answers may be asked for by several threads.
class Mirror {
 public:
  /// Looks for the plane. \pre the mesh outlives this
  explicit Mirror(const TriMesh& mesh);

  /// `error`, the plane's; and `problem`, a sentence, when that is too large for suggestions.
  io::Json facts() const;

  /// The point of the surface nearest to the mirror image of a point of it; nothing when that is the point
  /// itself or near it (0.02 of the diagonal), as on the plane. \throws InputError when facts() has a problem
  std::optional<SurfacePoint> image(const SurfacePoint& point) const;

 private:
  std::optional<std::string> problem() const;

  const TriMesh& mesh_;
  SurfaceIndex surface_;
  MirrorPlane plane_;
};

}  // namespace partwise::sketching
