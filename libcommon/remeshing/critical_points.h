#pragma once

#include <vector>

#include "remeshing/compatible_mesh.h"

namespace partwise {

struct CriticalPointOptions {
  /// Largest number of critical points as a share of the mesh's vertices, in (0, 1].
  double fraction = 0.1;
  /// Largest number of critical points; 0 leaves it to `fraction`.
  int count = 0;
};

/// Outcome of the search, most curved first.
struct CriticalPoints {
  std::vector<CriticalPoint> points;
  /// Factor on every radius of [Wu11] that was needed to stay within the bound; 1 when none was.
  double radius_scale = 1;
};

/// Vertices that carry the features of a surface ([Wu11] 6.1.1).
///
/// The vertex with the largest |K| (Eq. (16)) that is still free is critical; it removes all vertices whose
/// distance along the edges of the mesh is at most r = 1 / (l |K|), l the mesh's diagonal; repeated until no
/// vertex is free. K is per unit of area, so r is a length and scaling the mesh changes nothing. r is at most
/// l, for flat vertices. What a vertex removes is its region; with more components than points allowed, some
/// vertices are in none. Equal |K| (within rounding) are taken by ascending vertex.
///
/// Differs from [Wu11]: the number of points is bounded by widening all regions by one common factor, because
/// cutting the list short instead would leave the flatter regions without any point.
/// \throws InputError when the options are out of range
CriticalPoints find_critical_points(const TriMesh& mesh, const CriticalPointOptions& options = {});

/// Those of a compatible mesh's target, at most the share `fraction` of the vertices of the coarser of source
/// and target: every one of them is to be carried by a source vertex.
CriticalPoints find_critical_points(const CompatibleMesh& mesh, const CriticalPointOptions& options = {});

}  // namespace partwise
