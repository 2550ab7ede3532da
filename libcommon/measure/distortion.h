#pragma once

#include <array>
#include <vector>

#include "mesh/types.h"

namespace partwise {

/// Singular values of the linear map from one triangle to another, the larger first.
/// \return infinities for an original without area and an image with extent
std::array<double, 2> singular_values(const std::array<Vec3, 3>& original, const std::array<Vec3, 3>& image);

/// How far a piecewise linear map of a surface is from an isometry. Free of scale: the original is scaled to
/// the total area of the image first.
struct Distortion {
  /// Sander et al. 2001, inverted: A'^2 / (A sum A'_f (s1^2 + s2^2) / 2) with A the area of the original and
  /// A' of the image; 1 for an isometry, less for everything else.
  double l2_stretch_efficiency = 0;
  /// Mean of s1^2 + s2^2 + 1/s1^2 + 1/s2^2 over the original's area; 4 for an isometry.
  double symmetric_dirichlet = 0;
  /// Median of the same over the facets.
  double symmetric_dirichlet_median = 0;
  /// Mean absolute difference of the corners' angles, in degrees.
  double angle_error_degrees = 0;
  /// Facets whose singular values were clamped (see distortion).
  int clamped_facets = 0;
};

/// Distortion of the map that takes `original` to `image` facet by facet.
///
/// Singular values enter the means clamped to [1e-3, 1e3], so that one collapsed facet does not hide all
/// others; the number of such facets is reported. Facets of the original without area are left out of all
/// figures.
/// \pre both hold the positions of the facets' vertices
/// \throws InputError when either surface has no area
Distortion distortion(const Points& original, const Points& image, const Facets& facets);

/// Per facet s1^2 + s2^2 + 1/s1^2 + 1/s2^2, as it enters the figures of `distortion`; 4 for facets of the
/// original without area. \pre and \throws as `distortion`
std::vector<double> facet_dirichlet_energies(const Points& original, const Points& image,
                                             const Facets& facets);

}  // namespace partwise
