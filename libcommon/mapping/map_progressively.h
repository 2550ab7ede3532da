#pragma once

#include "mapping/domains.h"

namespace partwise {

/// A part on its own hull, and how good the map is.
struct ProgressiveMap {
  Points images;  ///< per local vertex of the part, on the hull, in the model's coordinates
  double distortion =
      0;  ///< symmetric Dirichlet, area-weighted mean of (|J|^2 + |J^-1|^2) / 4: 1 for an isometry
  int iterations = 0;
};

/// Weights for distortion, one per local vertex: caps are no part of the surface and count a tenth.
std::vector<double> distortion_weights(const Part& part);

/// Maps a capped part one-to-one onto its own hull: progressive embedding on the sphere, turned towards the
/// part's own directions, projected centrally onto the hull, then relaxed there without turning a facet over.
///
/// Differs from [Wu11] Eq. (13): whose energy folds on real parts; this map has no folds.
/// \throws InputError when the part has a handle; ComputationError when double precision does not suffice
ProgressiveMap map_progressively(const Part& part, const ConvexHull& hull);

/// The same from another start, which exists for every part without a handle: the disc around a vertex,
/// lifted to the sphere (embed_by_lifting). The vertex is the centre of the largest cap, or else the one with
/// the largest ring; where double precision does not suffice some others are tried. What follows is as in
/// map_progressively, with more steps, because the start is far from isometric.
/// 	hrows as map_progressively
ProgressiveMap map_by_lifting(const Part& part, const ConvexHull& hull);

}  // namespace partwise
