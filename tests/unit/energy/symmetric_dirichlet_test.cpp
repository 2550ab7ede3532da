#include "energy/symmetric_dirichlet.h"

#include <gtest/gtest.h>

#include <cmath>

namespace partwise {
namespace {

// A facet seen from the origin, over a surface at distance 2.
const Vec3 p0(0.1, -0.2, 2.0), p1(1.3, 0.1, 1.9), p2(0.4, 0.9, 2.2);

ReferenceTriangle some_reference() {
  return ReferenceTriangle::from({0, 0, 0}, {1.1, 0, 0}, {0.2, 0.8, 0}, 0, 0);
}

TEST(SymmetricDirichlet, OfAnIsometryIsFourTimesTheArea) {
  const ReferenceTriangle reference = ReferenceTriangle::from({0, 0, 0}, {1, 0, 0}, {0, 2, 0}, 0, 0);
  const FacetDistortion facet(reference, 3, {0, 0, 3}, {1, 0, 3}, {0, 2, 3});
  EXPECT_NEAR(facet.area_ratio(), 1, 1e-15);
  EXPECT_NEAR(facet.energy(), 4 * reference.area, 1e-14);
}

TEST(SymmetricDirichlet, OfAStretchByTwoAlongOneAxis) {
  const ReferenceTriangle reference = ReferenceTriangle::from({0, 0, 0}, {1, 0, 0}, {0, 2, 0}, 0, 0);
  const FacetDistortion facet(reference, 3, {0, 0, 3}, {2, 0, 3}, {0, 2, 3});
  EXPECT_NEAR(facet.energy(), reference.area * (4 + 1 + 0.25 + 1), 1e-14);
}

TEST(SymmetricDirichlet, IsInfiniteForAFacetTurnedOver) {
  EXPECT_TRUE(std::isinf(FacetDistortion(some_reference(), 2, p1, p0, p2).energy()));
}

TEST(SymmetricDirichlet, DerivativesAgreeWithDifferences) {
  const ReferenceTriangle reference = some_reference();
  const FacetDistortion facet(reference, 2, p0, p1, p2);
  const auto gradient = facet.full_gradient();
  const auto hessian = facet.full_hessian();
  constexpr double h = 1e-6;
  for (int i = 0; i < 9; ++i) {
    std::array<Vec3, 3> plus{p0, p1, p2}, minus{p0, p1, p2};
    plus[i / 3][i % 3] += h;
    minus[i / 3][i % 3] -= h;
    const FacetDistortion above(reference, 2, plus[0], plus[1], plus[2]);
    const FacetDistortion below(reference, 2, minus[0], minus[1], minus[2]);
    EXPECT_NEAR(gradient[i], (above.energy() - below.energy()) / (2 * h), 1e-7 * gradient.norm());
    const Eigen::Matrix<double, 9, 1> column = (above.full_gradient() - below.full_gradient()) / (2 * h);
    EXPECT_LT((hessian.col(i) - column).norm(), 1e-6 * hessian.norm());
  }
  EXPECT_LT((facet.gradient() - gradient.head<3>()).norm(), 1e-12 * gradient.norm());
  EXPECT_LT((facet.hessian() - hessian.topLeftCorner<3, 3>()).norm(), 1e-12 * hessian.norm());
}

TEST(SymmetricDirichlet, TakesAFlatReferenceForEquilateral) {
  const ReferenceTriangle flat = ReferenceTriangle::from({0, 0, 0}, {1, 0, 0}, {2, 1e-9, 0}, 0.02, 0.3);
  EXPECT_NEAR(flat.cotangents.maxCoeff(), 1 / std::sqrt(3.0), 1e-15);
  EXPECT_EQ(flat.area, 0.3);
}

}  // namespace
}  // namespace partwise
