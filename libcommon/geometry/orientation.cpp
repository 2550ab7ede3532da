#include "geometry/orientation.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace partwise {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 exact(const Vec3& point) {
  return {point.x(), point.y(), point.z()};
}

}  // namespace

int orientation_sign(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return static_cast<int>(CGAL::orientation(exact(a), exact(b), exact(c), exact(d)));
}

}  // namespace partwise
