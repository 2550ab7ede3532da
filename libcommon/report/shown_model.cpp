#include "report/shown_model.h"

#include <algorithm>

namespace partwise::report {

namespace {

constexpr double kShownDiagonal = 2.0;  // the page counts on it

}  // namespace

Frame centred_frame(const Points& points, const Eigen::Matrix3d& rotation) {
  Vec3 low = rotation * points.front();
  Vec3 high = low;
  for (const Vec3& p : points) {
    low = low.cwiseMin(rotation * p);
    high = high.cwiseMax(rotation * p);
  }
  const double scale = kShownDiagonal / std::max((high - low).norm(), 1e-300);
  Frame frame = Frame::Identity();
  frame.linear() = scale * rotation;
  frame.translation() = -scale * (low + high) / 2;
  return frame;
}

Eigen::Matrix3d rotation_of(const View& view) {
  Eigen::Matrix3d rotation;
  rotation << view.right.transpose(), view.up.transpose(), view.toward.transpose();
  return rotation;
}

Points moved(const Frame& frame, const Points& points) {
  Points result;
  result.reserve(points.size());
  for (const Vec3& p : points) result.push_back(frame * p);
  return result;
}

void PartNumbers::add(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (std::find(names_.begin(), names_.end(), name) == names_.end()) names_.push_back(name);
  }
}

std::vector<std::uint8_t> PartNumbers::of(const std::vector<std::string>& names,
                                          const std::vector<int>& labels) const {
  std::vector<std::uint8_t> numbers;
  for (const std::string& name : names) {
    const auto place = std::find(names_.begin(), names_.end(), name) - names_.begin();
    numbers.push_back(static_cast<std::uint8_t>(place));
  }
  return picked(numbers, labels);
}

}  // namespace partwise::report
