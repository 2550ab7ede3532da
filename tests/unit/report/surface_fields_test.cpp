#include "report/surface_fields.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "builders.h"

namespace partwise::report {
namespace {

// A mesh and its image under the linear map diag(x, y, z), as a "compatible mesh" on itself.
CompatibleMesh stretched(const TriMesh& mesh, const Vec3& factors) {
  Points points = mesh.points();
  for (Vec3& p : points) p = p.cwiseProduct(factors);
  const TriMesh target = mesh.with_points(points);
  std::vector<SurfacePoint> images(mesh.vertex_count());
  for (int f = 0; f < mesh.facet_count(); ++f) {
    for (int i = 0; i < 3; ++i) images[mesh.facet(f)[i]] = {f, Vec3::Unit(i)};
  }
  const std::vector<int> labels(mesh.facet_count(), 0);
  return {mesh, target, points, SurfaceMap(mesh, target, images), labels, labels, {"whole"}, {}, {}};
}

std::vector<int> up_to(int count) {
  std::vector<int> all(count);
  std::iota(all.begin(), all.end(), 0);
  return all;
}

TEST(SurfaceFields, ASimilarCopyHasNoDistortion) {
  const CompatibleMesh mesh = stretched(tests::sphere(4), Vec3(3, 3, 3));
  const FacetDistortion distortion = facet_distortion(mesh, up_to(mesh.source.facet_count()));
  for (const float value : distortion.dirichlet) EXPECT_NEAR(value, 4, 1e-5);
  for (const float value : distortion.area) EXPECT_NEAR(value, 0, 1e-5);
}

TEST(SurfaceFields, AStretchedGridHasTheDistortionOfItsFactors) {
  // Factors 2 and 1/2: equal area, s1 = 2, s2 = 1/2 everywhere.
  const CompatibleMesh mesh = stretched(tests::grid(4), Vec3(2, 0.5, 1));
  const FacetDistortion distortion = facet_distortion(mesh, {0, 5});
  ASSERT_EQ(distortion.dirichlet.size(), 2U);
  EXPECT_NEAR(distortion.dirichlet[1], 4 + 0.25 + 0.25 + 4, 1e-5);
  EXPECT_NEAR(distortion.area[1], 0, 1e-5);
}

TEST(SurfaceFields, DistancesAreOverTheTargetsDiagonal) {
  CompatibleMesh mesh = stretched(tests::grid(4), Vec3(1, 1, 1));
  for (Vec3& p : mesh.points) p.z() += 0.1;
  const double expected = 0.1 / std::sqrt(8);
  for (const float d : distances_to_target(mesh, up_to(4))) EXPECT_NEAR(d, expected, 1e-6);
  for (const float d : distances_to_compatible(mesh, up_to(4))) EXPECT_NEAR(d, expected, 1e-6);
}

TEST(SurfaceFields, QuantilesAreValues) {
  EXPECT_EQ(quantile({}, 0.5), 0);
  EXPECT_EQ(quantile({3, 1, 2}, 0), 1);
  EXPECT_EQ(quantile({3, 1, 2}, 0.5), 2);
  EXPECT_EQ(quantile({3, 1, 2}, 1), 3);
}

}  // namespace
}  // namespace partwise::report
