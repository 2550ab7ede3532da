#include "measure/distortion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "error.h"
#include "geometry/normals.h"

namespace partwise {
namespace {

using Corners = std::array<Vec3, 3>;

/// The triangle in its own plane: columns are its edges from corner 0, the first along the x axis.
Eigen::Matrix2d flattened(const Corners& corners) {
  const Vec3 u = corners[1] - corners[0], v = corners[2] - corners[0];
  const double length = u.norm();
  Eigen::Matrix2d edges;
  if (length > 0) {
    edges << length, u.dot(v) / length, 0, u.cross(v).norm() / length;
  } else {
    edges << 0, v.norm(), 0, 0;
  }
  return edges;
}

double corner_angle(const Corners& corners, int i) {
  const Vec3 u = corners[(i + 1) % 3] - corners[i], v = corners[(i + 2) % 3] - corners[i];
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

double angle_difference(const Corners& a, const Corners& b) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) sum += std::abs(corner_angle(a, i) - corner_angle(b, i));
  return sum;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (*std::max_element(values.begin(), middle) + *middle) / 2;
}

double total(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// The factor that gives the original the image's area.
double common_scale(const std::vector<double>& original_areas, const std::vector<double>& image_areas) {
  const double original_area = total(original_areas), image_area = total(image_areas);
  if (!(original_area > 0) || !(image_area > 0)) {
    throw InputError(
        "cannot measure distortion: " + std::string(original_area > 0 ? "the image" : "the original") +
        " has no area; check its vertex positions");
  }
  return std::sqrt(image_area / original_area);
}

/// Sums over facets from which the figures follow.
struct Sums {
  double stretch = 0, dirichlet = 0, angles = 0;
  std::vector<double> dirichlet_values;
  int clamped = 0;

  /// Areas are those of the original, scaled, and of the image.
  void add(double original_area, double image_area, const std::array<double, 2>& values) {
    constexpr double smallest = 1e-3, largest = 1e3;
    const double s1 = std::clamp(values[0], smallest, largest);
    const double s2 = std::clamp(values[1], smallest, largest);
    if (s1 != values[0] || s2 != values[1]) ++clamped;
    const double squares = s1 * s1 + s2 * s2;
    const double energy = squares + 1 / (s1 * s1) + 1 / (s2 * s2);
    stretch += image_area * squares / 2;
    dirichlet += original_area * energy;
    dirichlet_values.push_back(energy);
  }
};

}  // namespace

std::array<double, 2> singular_values(const Corners& original, const Corners& image) {
  const Eigen::Matrix2d from = flattened(original), to = flattened(image);
  const double determinant = from.determinant();
  if (!(determinant > 0)) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {infinity, infinity};
  }
  Eigen::Matrix2d inverse;
  inverse << from(1, 1), -from(0, 1), -from(1, 0), from(0, 0);
  const Eigen::Matrix2d jacobian = to * inverse / determinant;
  const double conformal = std::hypot(jacobian(0, 0) + jacobian(1, 1), jacobian(0, 1) - jacobian(1, 0));
  const double anticonformal = std::hypot(jacobian(0, 0) - jacobian(1, 1), jacobian(0, 1) + jacobian(1, 0));
  return {(conformal + anticonformal) / 2, std::abs(conformal - anticonformal) / 2};
}

std::vector<double> facet_dirichlet_energies(const Points& original, const Points& image,
                                             const Facets& facets) {
  const double scale = common_scale(facet_areas(original, facets), facet_areas(image, facets));
  std::vector<double> energies;
  energies.reserve(facets.size());
  for (const auto& [a, b, c] : facets) {
    const Corners from{scale * original[a], scale * original[b], scale * original[c]};
    Sums sums;
    sums.add(1, 1, singular_values(from, {image[a], image[b], image[c]}));
    energies.push_back(area_vector(from[0], from[1], from[2]).isZero(0) ? 4 : sums.dirichlet);
  }
  return energies;
}

Distortion distortion(const Points& original, const Points& image, const Facets& facets) {
  const std::vector<double> original_areas = facet_areas(original, facets);
  const std::vector<double> image_areas = facet_areas(image, facets);
  const double scale = common_scale(original_areas, image_areas), image_area = total(image_areas);
  Sums sums;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    if (!(original_areas[f] > 0)) continue;
    const auto& [a, b, c] = facets[f];
    const Corners from{scale * original[a], scale * original[b], scale * original[c]};
    const Corners to{image[a], image[b], image[c]};
    sums.add(scale * scale * original_areas[f], image_areas[f], singular_values(from, to));
    sums.angles += angle_difference(from, to);
  }
  Distortion result;
  result.l2_stretch_efficiency = image_area / sums.stretch;
  result.symmetric_dirichlet = sums.dirichlet / image_area;
  result.symmetric_dirichlet_median = median(sums.dirichlet_values);
  result.angle_error_degrees =
      sums.angles / (3.0 * static_cast<double>(sums.dirichlet_values.size())) * 180 / std::numbers::pi;
  result.clamped_facets = sums.clamped;
  return result;
}

}  // namespace partwise
