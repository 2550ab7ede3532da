#include "geometry/mean_value_weights.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace partwise {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

/// `combine` joins the entries that several facets give for one edge.
template <class Combine>
VertexWeights with_rows_summing_to_one(std::size_t vertex_count, const Triplets& triplets, Combine combine) {
  const auto n = static_cast<Eigen::Index>(vertex_count);
  VertexWeights weights(n, n);
  weights.setFromTriplets(triplets.begin(), triplets.end(), combine);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double sum = weights.row(i).sum();
    if (sum > 0) weights.row(i) /= sum;
  }
  return weights;
}

/// tan(angle / 2) between two directions, by |u x v| / (|u||v| + u.v): no trigonometry, no division by zero
/// but for opposite directions, where it is bounded.
double half_angle_tangent(const Vec3& u, const Vec3& v) {
  constexpr double largest = 1e6;
  const double sine = u.cross(v).norm();
  const double denominator = u.norm() * v.norm() + u.dot(v);
  return sine < largest * denominator ? sine / denominator : largest;
}

}  // namespace

VertexWeights mean_value_weights(const Points& points, const Facets& facets) {
  const double shortest = 1e-12 * bounding_box_diagonal(points);
  Triplets triplets;
  triplets.reserve(facets.size() * 6);
  for (const Facet& f : facets) {
    for (int k = 0; k < 3; ++k) {
      const int i = f[k], j = f[(k + 1) % 3], l = f[(k + 2) % 3];
      const Vec3 to_j = points[j] - points[i], to_l = points[l] - points[i];
      const double tangent = half_angle_tangent(to_j, to_l);
      triplets.emplace_back(i, j, tangent / std::max(to_j.norm(), shortest));
      triplets.emplace_back(i, l, tangent / std::max(to_l.norm(), shortest));
    }
  }
  return with_rows_summing_to_one(points.size(), triplets, std::plus<>());
}

VertexWeights uniform_weights(std::size_t vertex_count, const Facets& facets) {
  Triplets triplets;
  triplets.reserve(facets.size() * 6);
  for (const Facet& f : facets) {
    for (int k = 0; k < 3; ++k) {
      triplets.emplace_back(f[k], f[(k + 1) % 3], 1.0);
      triplets.emplace_back(f[k], f[(k + 2) % 3], 1.0);
    }
  }
  return with_rows_summing_to_one(vertex_count, triplets, [](double, double) { return 1.0; });
}

}  // namespace partwise
