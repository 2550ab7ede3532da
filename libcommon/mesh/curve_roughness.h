#pragma once

#include "mesh/segmentation.h"

namespace partwise {

/// Rounds of smoothing that curve_roughness compares with.
inline constexpr int kRoughnessRounds = 5;

/// Length of a polyline over its length after kRoughnessRounds rounds of p_i <- (p_i-1 + 2 p_i + p_i+1) / 4:
/// 1 for a straight line, more the more it zigzags from vertex to vertex.
///
/// The ends of an open polyline stay; a closed one does not repeat its first vertex. A smooth closed curve
/// of n vertices is left with about 1 + 50 / n^2, since smoothing shrinks it. 1 when the smoothed length is
/// 0.
double curve_roughness(const Points& polyline, bool closed);

/// Roughness of a boundary curve.
double curve_roughness(const TriMesh& mesh, const BoundaryCurve& curve);

/// Total length of all boundary curves over their total length once smoothed; 1 when there are none.
double mean_roughness(const TriMesh& mesh, const Segmentation& segmentation);

}  // namespace partwise
