#include "mapping/loop_shift.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace partwise {
namespace {

/// A closed polygon by arc length, its total length being 1.
class Loop {
 public:
  explicit Loop(const Points& points) : points_(points) {
    fractions_.push_back(0);
    for (std::size_t i = 0; i < points.size(); ++i) {
      fractions_.push_back(fractions_.back() + (points[(i + 1) % points.size()] - points[i]).norm());
    }
    length_ = fractions_.back();
    for (double& fraction : fractions_) fraction /= length_;
  }

  double length() const { return length_; }
  const std::vector<double>& fractions() const { return fractions_; }

  Vec3 at(double fraction) const {
    fraction -= std::floor(fraction);
    const auto after = std::upper_bound(fractions_.begin() + 1, fractions_.end() - 1, fraction);
    const std::size_t i = static_cast<std::size_t>(after - fractions_.begin()) - 1;
    const double span = fractions_[i + 1] - fractions_[i];
    const double t = span > 0 ? (fraction - fractions_[i]) / span : 0;
    return (1 - t) * points_[i] + t * points_[(i + 1) % points_.size()];
  }

 private:
  const Points& points_;
  std::vector<double> fractions_;
  double length_ = 0;
};

Points samples(const Loop& loop, std::size_t count, double scale) {
  Points result;
  Vec3 mean = Vec3::Zero();
  for (std::size_t i = 0; i < count; ++i) {
    result.push_back(loop.at(static_cast<double>(i) / static_cast<double>(count)));
    mean += result.back() / static_cast<double>(count);
  }
  for (Vec3& point : result) point = scale * (point - mean);
  return result;
}

double circular_distance(double a, double b) {
  const double d = std::abs(a - b);
  return std::min(d, 1 - d);
}

}  // namespace

LoopShift best_shift(const Points& source, const Points& target, double diagonal) {
  constexpr std::size_t kSamples = 256;
  constexpr double kApart = 1.0 / 16;
  const Loop from(source), to(target);
  const Points from_samples = samples(from, kSamples, to.length() / from.length());
  Vec3 centre = Vec3::Zero();
  for (std::size_t i = 0; i < kSamples; ++i) centre += to.at(static_cast<double>(i) / kSamples) / kSamples;

  std::vector<double> candidates(to.fractions().begin(), to.fractions().end() - 1);
  for (std::size_t i = 0; i < kSamples; ++i) candidates.push_back(static_cast<double>(i) / kSamples);
  std::vector<double> costs;
  for (const double shift : candidates) {
    double sum = 0;
    for (std::size_t i = 0; i < kSamples; ++i) {
      const Vec3 there = to.at(static_cast<double>(i) / kSamples + shift) - centre;
      sum += (from_samples[i] - there).squaredNorm();
    }
    costs.push_back(std::sqrt(sum / kSamples) / diagonal);
  }
  const std::size_t best =
      static_cast<std::size_t>(std::min_element(costs.begin(), costs.end()) - costs.begin());
  LoopShift result{candidates[best], costs[best], candidates[best], std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const bool apart = circular_distance(candidates[i], candidates[best]) >= kApart;
    if (!apart || costs[i] >= result.other_rms_distance) continue;
    result.other_shift = candidates[i];
    result.other_rms_distance = costs[i];
  }
  return result;
}

}  // namespace partwise
