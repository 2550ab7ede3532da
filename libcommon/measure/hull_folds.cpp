#include "measure/hull_folds.h"

#include <cmath>
#include <numbers>

#include "geometry/orientation.h"

namespace partwise {
namespace {

/// Signed solid angle of a triangle of unit directions (Van Oosterom and Strackee 1983), in steradians. The
/// difference form of the volume keeps the sign of small triangles.
double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double volume = a.dot((b - a).cross(c - a));
  return 2 * std::atan2(volume, 1 + a.dot(b) + b.dot(c) + c.dot(a));
}

}  // namespace

HullFolds hull_folds(const Points& images, const Facets& facets, const Vec3& centre) {
  Points directions;
  directions.reserve(images.size());
  for (const Vec3& p : images) directions.push_back((p - centre).stableNormalized());
  HullFolds result;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const auto& [i, j, k] = facets[f];
    if (orientation_sign(centre, images[i], images[j], images[k]) <= 0) {
      result.folded.push_back(static_cast<int>(f));
    }
    result.degree += solid_angle(directions[i], directions[j], directions[k]) / (4 * std::numbers::pi);
  }
  return result;
}

}  // namespace partwise
