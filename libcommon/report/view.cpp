#include "report/view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "error.h"

namespace partwise::report {

namespace {

constexpr std::array kSlices = {0.02, 0.04, 0.08};  // of the extent: what counts as touching the ground
constexpr double kUsualUp = 1.5;                    // how much likelier y is up than another direction
constexpr double kTurn = 0.45;                      // radians to the side
constexpr double kElevation = 0.22;                 // radians from above

struct Box {
  Vec3 low;
  Vec3 high;
  explicit Box(const Vec3& p) : low(p), high(p) {}
  void add(const Vec3& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  Vec3 extent() const { return high - low; }
};

Box bounding_box(const Points& points) {
  Box box(points.front());
  for (const Vec3& p : points) {
    box.add(p);
  }
  return box;
}

// How widely the model spreads over the ground when `sign` times `axis` points up: 0 ... 1.
double footprint(const Points& points, const Box& box, int axis, double sign, double thickness) {
  const double ground = sign > 0 ? box.low[axis] : box.high[axis];
  const double reach = thickness * box.extent()[axis];
  const int a = (axis + 1) % 3;
  const int b = (axis + 2) % 3;
  Box slice(Vec3::Zero());
  bool empty = true;
  for (const Vec3& p : points) {
    if (std::abs(p[axis] - ground) > reach) continue;
    if (empty) slice = Box(p);
    empty = false;
    slice.add(p);
  }
  const Vec3 spread = slice.extent();
  const Vec3 whole = box.extent();
  return spread[a] * spread[b] / std::max(whole[a] * whole[b], 1e-300);
}

}  // namespace

View view_from(const Vec3& toward, const Vec3& up) {
  const Vec3 right = up.cross(toward);
  if (!(right.norm() > 1e-9 * up.norm() * toward.norm())) {
    throw InputError("view: the direction to the eye and the upward direction are parallel or zero");
  }
  View view;
  view.toward = toward.normalized();
  view.right = right.normalized();
  view.up = view.toward.cross(view.right);
  return view;
}

View parse_view(const std::string& text) {
  std::istringstream in(text);
  std::array<double, 6> n{};
  bool understood = true;
  for (std::size_t i = 0; i < n.size(); ++i) {
    char comma = ',';
    understood = understood && (i == 0 || in >> comma) && comma == ',' && in >> n[i];
  }
  if (!understood || in.peek() != std::istringstream::traits_type::eof()) {
    throw UsageError("view \"" + text +
                     "\": give six numbers, the direction to the eye and the upward direction: x,y,z,x,y,z");
  }
  return view_from(Vec3(n[0], n[1], n[2]), Vec3(n[3], n[4], n[5]));
}

View automatic_view(const Points& points) {
  const Box box = bounding_box(points);
  int side = 0;
  box.extent().minCoeff(&side);
  int best_axis = (side + 1) % 3;
  double best_sign = 1;
  double widest = -1;
  for (const int axis : {(side + 1) % 3, (side + 2) % 3}) {
    for (const double sign : {1.0, -1.0}) {
      double spread = 0;
      for (const double thickness : kSlices) {
        spread += footprint(points, box, axis, sign, thickness);
      }
      if (axis == 1 && sign > 0) spread *= kUsualUp;
      if (spread <= widest) continue;
      widest = spread;
      best_axis = axis;
      best_sign = sign;
    }
  }
  const Vec3 up = best_sign * Vec3::Unit(best_axis);
  const Vec3 across = Vec3::Unit(side);
  const Vec3 along = up.cross(across);
  const Vec3 level = std::cos(kTurn) * across + std::sin(kTurn) * along;
  return view_from(std::cos(kElevation) * level + std::sin(kElevation) * up, up);
}

}  // namespace partwise::report
