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

/// How far two closed curves are apart, turn by turn.
class Turns {
 public:
  Turns(const Points& source, const Points& target, double diagonal)
      : to_(target), diagonal_(diagonal), centre_(Vec3::Zero()) {
    const Loop from(source);
    from_ = samples(from, kSamples, to_.length() / from.length());
    for (std::size_t i = 0; i < kSamples; ++i) {
      centre_ += to_.at(static_cast<double>(i) / kSamples) / kSamples;
      shifts_.push_back(static_cast<double>(i) / kSamples);
    }
    shifts_.insert(shifts_.begin(), to_.fractions().begin(), to_.fractions().end() - 1);
    for (const double shift : shifts_) distances_.push_back(rms_distance(shift));
  }

  double best() const {
    return shifts_[std::min_element(distances_.begin(), distances_.end()) - distances_.begin()];
  }

  LoopShift beside_others(double shift) const {
    LoopShift result;
    result.shift = result.other_shift = shift;
    result.rms_distance = rms_distance(shift);
    result.other_rms_distance = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < shifts_.size(); ++i) {
      const bool apart = circular_distance(shifts_[i], shift) >= kApart;
      if (!apart || distances_[i] >= result.other_rms_distance) continue;
      result.other_shift = shifts_[i];
      result.other_rms_distance = distances_[i];
    }
    return result;
  }

 private:
  static constexpr std::size_t kSamples = 256;
  static constexpr double kApart = 1.0 / 16;

  double rms_distance(double shift) const {
    double sum = 0;
    for (std::size_t i = 0; i < kSamples; ++i) {
      const Vec3 there = to_.at(static_cast<double>(i) / kSamples + shift) - centre_;
      sum += (from_[i] - there).squaredNorm();
    }
    return std::sqrt(sum / kSamples) / diagonal_;
  }

  const Loop to_;
  const double diagonal_;
  Points from_;
  Vec3 centre_;
  std::vector<double> shifts_, distances_;
};

}  // namespace

LoopShift best_shift(const Points& source, const Points& target, double diagonal) {
  const Turns turns(source, target, diagonal);
  return turns.beside_others(turns.best());
}

LoopShift given_shift(const Points& source, const Points& target, double diagonal, double shift) {
  return Turns(source, target, diagonal).beside_others(shift);
}

}  // namespace partwise
