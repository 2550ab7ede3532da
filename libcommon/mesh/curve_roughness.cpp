#include "mesh/curve_roughness.h"

namespace partwise {
namespace {

double length_of(const Points& polyline, bool closed) {
  double sum = 0;
  for (std::size_t i = 1; i < polyline.size(); ++i) sum += (polyline[i] - polyline[i - 1]).norm();
  return closed ? sum + (polyline.front() - polyline.back()).norm() : sum;
}

Points smoothed(const Points& polyline, bool closed) {
  Points result = polyline;
  const std::size_t n = polyline.size();
  const std::size_t first = closed ? 0 : 1, last = closed ? n : n - 1;
  for (std::size_t i = first; i < last; ++i) {
    result[i] = (polyline[(i + n - 1) % n] + 2 * polyline[i] + polyline[(i + 1) % n]) / 4;
  }
  return result;
}

}  // namespace

double curve_roughness(const Points& polyline, bool closed) {
  if (polyline.size() < 2) return 1;
  Points smooth = polyline;
  for (int round = 0; round < kRoughnessRounds; ++round) smooth = smoothed(smooth, closed);
  const double remaining = length_of(smooth, closed);
  return remaining > 0 ? length_of(polyline, closed) / remaining : 1;
}

double curve_roughness(const TriMesh& mesh, const BoundaryCurve& curve) {
  Points polyline;
  for (const int v : curve.vertices) polyline.push_back(mesh.point(v));
  return curve_roughness(polyline, curve.closed);
}

double mean_roughness(const TriMesh& mesh, const Segmentation& segmentation) {
  double length = 0, smoothed = 0;
  for (const BoundaryCurve& curve : segmentation.curves) {
    length += curve.length;
    smoothed += curve.length / curve_roughness(mesh, curve);
  }
  return smoothed > 0 ? length / smoothed : 1;
}

}  // namespace partwise
