#include "geometry/edge_cotangent.h"

#include <algorithm>

namespace partwise {

double bounded_half_cotangent(const Vec3& a, const Vec3& b) {
  constexpr double least = 1e-2, largest = 1e2;
  const double sine = a.cross(b).norm(), cosine = a.dot(b);
  if (!(2 * largest * sine > cosine)) return cosine > 0 ? largest : least;
  return std::max(least, 0.5 * cosine / sine);
}

}  // namespace partwise
