#include "measure/measurement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "builders.h"
#include "error.h"

namespace partwise {
namespace {

/// The mesh mapped onto itself by the identity, its points moved by `move`.
CompatibleMesh onto_itself(const TriMesh& mesh, auto&& move) {
  std::vector<SurfacePoint> images(mesh.vertex_count());
  for (int f = 0; f < mesh.facet_count(); ++f) {
    for (int i = 0; i < 3; ++i) images[mesh.facet(f)[i]] = {f, Vec3::Unit(i)};
  }
  Points points;
  for (const Vec3& p : mesh.points()) points.push_back(move(p));
  const std::vector<int> labels(mesh.facet_count(), 0);
  return {
      mesh,
      mesh,
      points,
      SurfaceMap(mesh, mesh, images),
      labels,
      labels,
      {"whole"},
      {{"first", {0, Vec3::Unit(0)}, {0, Vec3::Unit(0)}}, {"second", {1, Vec3::Unit(0)}, {1, Vec3::Unit(0)}}},
      {}};
}

TEST(Measurement, OfTheIdentityIsPerfect) {
  const TriMesh sphere = tests::sphere(6);
  const Measurement result = measure(onto_itself(sphere, [](const Vec3& p) { return p; }), {.samples = 1000},
                                     identity_truth(sphere, sphere));
  EXPECT_EQ(result.source_facets, 288);
  EXPECT_EQ(result.target_facets, 288);
  EXPECT_EQ(result.parts, 1);
  EXPECT_LT(result.distance.max, 1e-14);
  EXPECT_EQ(result.flipped_facets, 0);
  EXPECT_EQ(result.self_intersections.compatible, 0);
  EXPECT_EQ(result.degenerate_facets, 0);
  EXPECT_NEAR(result.distortion->symmetric_dirichlet, 4, 1e-12);
  ASSERT_EQ(result.marker_errors.size(), 2U);
  EXPECT_EQ(result.marker_errors[1].error, 0);
  EXPECT_EQ(result.truth->max, 0);
}

TEST(Measurement, MarkerErrorsAreOverTheTargetsDiagonal) {
  const TriMesh grid = tests::grid(4);
  const Measurement result =
      measure(onto_itself(grid, [](const Vec3& p) -> Vec3 { return p + Vec3(0, 0, 0.5); }), {.samples = 100});
  EXPECT_NEAR(result.marker_errors[0].error, 0.5 / std::sqrt(8.0), 1e-14);
  EXPECT_NEAR(result.map_gap, 0.5, 1e-14);
  EXPECT_NEAR(result.distance.forward.max_at_vertices / result.target_diagonal, 0.5 / std::sqrt(8.0), 1e-14);
}

TEST(Measurement, ACollapsedMeshHasNoDistortionButEverythingElse) {
  const Measurement result = measure(
      onto_itself(tests::cube(2), [](const Vec3&) -> Vec3 { return Vec3(1, 1, 1); }), {.samples = 100});
  EXPECT_FALSE(result.distortion);
  EXPECT_EQ(result.degenerate_facets, 48);
  EXPECT_EQ(result.self_intersections.compatible, 0);
  EXPECT_GT(result.distance.backward.max, 3.4);
}

TEST(Measurement, DoesNotDependOnTheNumberingOrThePlace) {
  const TriMesh mesh = tests::bumpy_sphere(8, 0.3);
  auto bend = [](const Vec3& p) -> Vec3 { return p + Vec3(0.2 * p.y() * p.y(), 0, 0.1 * p.x()); };
  const Measurement here = measure(onto_itself(mesh, bend), {.samples = 20000});

  std::vector<int> renumbered(mesh.vertex_count());
  for (int v = 0; v < mesh.vertex_count(); ++v) renumbered[v] = (v * 5 + 3) % mesh.vertex_count();
  std::vector<int> sorted = renumbered;
  std::sort(sorted.begin(), sorted.end());
  ASSERT_EQ(std::unique(sorted.begin(), sorted.end()), sorted.end()) << "5 must not divide the vertex count";
  const Eigen::AngleAxisd turn(0.9, Vec3(3, -1, 2).normalized());
  Points points(mesh.vertex_count());
  for (int v = 0; v < mesh.vertex_count(); ++v) points[renumbered[v]] = 40 * (turn * mesh.point(v));
  Facets facets;
  for (const auto& [a, b, c] : mesh.facets()) facets.push_back({renumbered[b], renumbered[c], renumbered[a]});
  std::reverse(facets.begin(), facets.end());
  const Measurement there =
      measure(onto_itself(TriMesh(points, facets),
                          [&](const Vec3& p) -> Vec3 { return 40 * (turn * bend(turn.inverse() * p / 40)); }),
              {.samples = 20000});

  // Samples fall elsewhere, so this one agrees within the error of sampling only.
  EXPECT_NEAR(there.distance.rms / 40, here.distance.rms, 1e-2 * here.distance.rms);
  EXPECT_NEAR(there.distance.forward.max_at_vertices / 40, here.distance.forward.max_at_vertices, 1e-9);
  EXPECT_EQ(there.flipped_facets, here.flipped_facets);
  EXPECT_EQ(there.self_intersections.compatible, here.self_intersections.compatible);
  EXPECT_NEAR(there.distortion->symmetric_dirichlet, here.distortion->symmetric_dirichlet, 1e-9);
  EXPECT_NEAR(there.distortion->l2_stretch_efficiency, here.distortion->l2_stretch_efficiency, 1e-9);
  EXPECT_NEAR(there.distortion->angle_error_degrees, here.distortion->angle_error_degrees, 1e-9);
}

TEST(Measurement, AgainstAPointIsAnError) {
  const TriMesh mesh = tests::tetrahedron();
  CompatibleMesh compatible = onto_itself(mesh, [](const Vec3& p) { return p; });
  compatible.target = mesh.with_points(Points(4, Vec3::Zero()));
  EXPECT_THROW(measure(compatible), InputError);
}

}  // namespace
}  // namespace partwise
