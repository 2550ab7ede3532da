#include "remeshing/relocate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "builders.h"
#include "convex_pairs.h"
#include "error.h"
#include "geometry/surface_index.h"
#include "mapped_pairs.h"
#include "remeshing/critical_points.h"
#include "remeshing/reconstruct.h"

namespace partwise {
namespace {

CompatibleMesh projected(const TriMesh& source, const TriMesh& target, std::vector<MarkerPair> markers = {}) {
  return reconstruct(tests::projected_pair(tests::whole(source), tests::whole(target), std::move(markers)))
      .mesh;
}

double mean_distance(const Points& a, const Points& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).norm();
  return sum / static_cast<double>(a.size());
}

double farthest(const Points& from, const CompatibleMesh& to) {
  const SurfaceIndex surface(to.points, to.source.facets());
  double largest = 0;
  for (const Vec3& p : from) largest = std::max(largest, surface.closest(p).distance);
  return largest;
}

TEST(Relocate, LeavesAPlaneOnItselfAlone) {
  const CompatibleMesh mesh = tests::shaken(tests::grid(8), 0, 1);
  EXPECT_LT(mean_distance(relocate(mesh).mesh.points, mesh.points), 1e-12);
}

TEST(Relocate, BringsBackTheShapeOfTheSource) {
  const TriMesh flat = tests::grid(8);
  const CompatibleMesh mesh = tests::shaken(flat, 0.4, 2);
  const Relocation result = relocate(mesh, {.rounds = 30});
  EXPECT_LT(mean_distance(result.mesh.points, flat.points()),
            0.2 * mean_distance(mesh.points, flat.points()));
}

TEST(Relocate, KeepsVerticesOnTheTargetAndTheMapUpToDate) {
  const TriMesh target = tests::bumpy_sphere(14, 0.3);
  CompatibleMesh mesh = projected(tests::cube(8), target);
  mesh.critical_points = find_critical_points(mesh).points;
  const Relocation result = relocate(mesh);
  const SurfaceIndex surface(target);
  for (int v = 0; v < mesh.source.vertex_count(); ++v) {
    EXPECT_EQ(result.mesh.points[v], position(target, result.mesh.map[v]));
    EXPECT_LT(surface.closest(result.mesh.points[v]).distance, 1e-15 * target.diagonal());
  }
  EXPECT_GT(mean_distance(result.mesh.points, mesh.points), 1e-3);
}

TEST(Relocate, NeverAddsFlippedFacets) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    const double size = 0.3 * (seed % 3 + 1);
    const CompatibleMesh mesh = tests::shaken(seed < 3 ? tests::sphere(8) : tests::cube(5), size, seed);
    MeshOnSurface moving(mesh);
    const VertexWeights weights = mean_value_weights(mesh.source.points(), mesh.source.facets());
    for (int round = 0; round < 4; ++round) {
      const int before = moving.flipped_count();
      relocation_round(moving, weights, 1);
      EXPECT_LE(moving.flipped_count(), before);
    }
    const int before = moving.flipped_count();
    fit_coverage(moving);
    EXPECT_LE(moving.flipped_count(), before);
    EXPECT_LE(unfold(moving), before);
  }
}

TEST(Relocate, UnfoldsWhatIsFlipped) {
  const CompatibleMesh mesh = tests::shaken(tests::sphere(10), 0.8, 3);
  MeshOnSurface moving(mesh);
  ASSERT_GT(moving.flipped_count(), 20);
  EXPECT_EQ(unfold(moving, {.sweeps = 200}), 0);
  EXPECT_EQ(moving.flipped_count(), 0);
}

TEST(Relocate, RelaxationEvensOutAShakenMap) {
  const TriMesh flat = tests::grid(8);
  const CompatibleMesh mesh = tests::shaken(flat, 0.4, 5);
  MeshOnSurface moving(mesh);
  relax(moving, 100, std::vector<double>(flat.facet_count(), 1.0));
  EXPECT_LT(mean_distance(moving.points(), flat.points()), 0.02 * mean_distance(mesh.points, flat.points()));
}

TEST(Relocate, PutsVerticesOnTheTipsOfBumps) {
  const TriMesh target = tests::bumpy_sphere(24, 0.4);
  CompatibleMesh mesh = projected(tests::cube(9), target);
  Points tips;
  for (const CriticalPoint& c : find_critical_points(target, {.fraction = 1, .count = 6}).points) {
    tips.push_back(target.point(c.vertex));
  }
  const double without = farthest(tips, mesh);
  EXPECT_GT(without, 0.02);
  mesh.critical_points = find_critical_points(mesh).points;
  const Relocation result = relocate(mesh);
  EXPECT_LT(farthest(tips, result.mesh), 1e-9);
  EXPECT_GT(result.metrics.critical_reached, 6);
  EXPECT_LE(result.metrics.critical_reached, result.metrics.critical_points);
  EXPECT_EQ(result.metrics.flipped_after, 0);
  EXPECT_LT(result.metrics.rms_distance_after, result.metrics.rms_distance_before);
}

TEST(Relocate, FitBringsTheMeshNearerToTheTarget) {
  CompatibleMesh mesh = projected(tests::sphere(10), tests::bumpy_sphere(24, 0.4));
  MeshOnSurface moving(mesh);
  EXPECT_GT(fit_coverage(moving), 0);
  CompatibleMesh fitted = mesh;
  fitted.points = moving.points();
  EXPECT_LT(farthest(mesh.target.points(), fitted), 0.8 * farthest(mesh.target.points(), mesh));
}

TEST(Relocate, KeepsMarkersAndTheBoundaryInPlace) {
  const TriMesh cup = tests::hemisphere(8);
  CompatibleMesh mesh = tests::shaken(cup, 0.3, 4);
  const int pinned = cup.facet(17)[1];
  mesh.markers = {{"spot", {17, Vec3::Unit(1)}, mesh.map[pinned]}};
  const Relocation result = relocate(mesh);
  EXPECT_EQ(result.mesh.points[pinned], mesh.points[pinned]);
  int boundary = 0;
  for (int v = 0; v < cup.vertex_count(); ++v) {
    if (!cup.half_edges().is_boundary(OpenMesh::VertexHandle(v))) continue;
    ++boundary;
    EXPECT_EQ(result.mesh.points[v], mesh.points[v]);
  }
  EXPECT_EQ(boundary, 32);
}

TEST(Relocate, DoesNotDependOnScale) {
  const TriMesh source = tests::cube(6), target = tests::bumpy_sphere(12, 0.3);
  CompatibleMesh mesh = projected(source, target);
  mesh.critical_points = find_critical_points(mesh).points;
  Points larger = target.points();
  for (Vec3& p : larger) p *= 1024;
  CompatibleMesh scaled = mesh;
  scaled.target = target.with_points(larger);
  scaled.points = mesh.map.positions(scaled.target);
  const Points expected = relocate(mesh).mesh.points;
  Points result = relocate(scaled).mesh.points;
  for (Vec3& p : result) p /= 1024;
  EXPECT_LT(mean_distance(result, expected), 1e-9);
}

TEST(Relocate, TheUmbrellaEndsOnTheTargetAtItsCriticalPoints) {
  const TriMesh target = tests::bumpy_sphere(24, 0.4);
  CompatibleMesh mesh = projected(tests::cube(9), target);
  const SurfaceIndex surface(target);
  const Relocation without = relocate(mesh, {.method = RelocateMethod::umbrella});
  mesh.critical_points = find_critical_points(mesh).points;
  const Relocation with = relocate(mesh, {.method = RelocateMethod::umbrella});
  EXPECT_GT(with.metrics.critical_reached, 6);
  for (const Vec3& p : with.mesh.points) EXPECT_LT(surface.closest(p).distance, 1e-12);
  EXPECT_LT(with.metrics.rms_distance_after, 0.5 * without.metrics.rms_distance_after);
}

TEST(Relocate, AnUmbrellaThatBreaksTheMapSaysSo) {
  CompatibleMesh mesh = projected(tests::cube(9), tests::bumpy_sphere(24, 0.4));
  mesh.critical_points = find_critical_points(mesh).points;
  const Relocation result = relocate(mesh, {.method = RelocateMethod::umbrella});
  ASSERT_EQ(result.metrics.charts.size(), 1U);
  EXPECT_EQ(result.metrics.charts[0].one_to_one, !result.mesh.charts.empty());
  EXPECT_EQ(result.metrics.charts[0].reason.empty(), !result.mesh.charts.empty());
}

TEST(Relocate, UniformWeightsLoseTheShapeOfTheSource) {
  // One half of the grid finer than the other: uniform weights even that out.
  const TriMesh flat = tests::grid(8);
  Points points = flat.points();
  for (Vec3& p : points) p.x() += 0.3 * (1 - p.x() * p.x());
  const CompatibleMesh mesh = tests::shaken(flat.with_points(points), 0, 1);
  const auto moved = [&](LaplacianKind weights) {
    const Relocation result =
        relocate(mesh, {.method = RelocateMethod::umbrella, .rounds = 20, .umbrella_weights = weights});
    return mean_distance(result.mesh.points, mesh.points);
  };
  EXPECT_LT(moved(LaplacianKind::mean_value), 1e-9);
  EXPECT_GT(moved(LaplacianKind::uniform), 0.01);
}

TEST(Relocate, RefusesOptionsOutOfRange) {
  const CompatibleMesh mesh = tests::shaken(tests::tetrahedron(), 0, 1);
  EXPECT_THROW(relocate(mesh, {.lambda = 0}), InputError);
  EXPECT_THROW(relocate(mesh, {.lambda = 1.1}), InputError);
  EXPECT_THROW(relocate(mesh, {.rounds = -1}), InputError);
  EXPECT_THROW(relocate(mesh, {.gaps = {.rounds = -1}}), InputError);
  EXPECT_THROW(relocate(mesh, {.gaps = {.threshold = 0}}), InputError);
}

}  // namespace
}  // namespace partwise
