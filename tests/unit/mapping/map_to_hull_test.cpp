#include "mapping/map_to_hull.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "builders.h"
#include "geometry/surface_index.h"
#include "mapping/build_hulls.h"
#include "mapping/split_chords.h"
#include "point_sets.h"

namespace partwise {
namespace {

using tests::largest_distance;

constexpr HullMapMethod kMethods[] = {HullMapMethod::progressive, HullMapMethod::lifted,
                                      HullMapMethod::energy};

HulledModel whole(const TriMesh& mesh) {
  const std::vector<int> labels(mesh.facet_count(), 0);
  return build_hulls({mesh, trace_boundaries(mesh, {"whole"}, labels), {}, {}, {}});
}

HulledModel halves(const TriMesh& mesh) {
  std::vector<int> labels;
  for (const Facet& f : mesh.facets()) {
    labels.push_back(mesh.point(f[0]).z() + mesh.point(f[1]).z() + mesh.point(f[2]).z() < 0 ? 1 : 0);
  }
  return build_hulls({mesh, trace_boundaries(mesh, {"top", "bottom"}, labels), {}, {}, {}});
}

MappedToHull mapped(const HulledModel& hulled, HullMapMethod method) {
  MapToHullOptions options;
  options.method = method;
  return map_to_hull(hulled, options);
}

/// A shape without symmetries, so that no tie is decided by rounding.
TriMesh irregular() {
  const TriMesh mesh = tests::bumpy_sphere(6, 0.5);
  Points points = mesh.points();
  for (Vec3& p : points)
    p *= 1 + 0.03 * std::sin(5 * p.x() + 1) + 0.04 * std::sin(3 * p.y() + 2) + 0.02 * std::sin(7 * p.z());
  return mesh.with_points(points);
}

void expect_on_hull(const HulledModel& hulled, const MappedToHull& result) {
  for (std::size_t k = 0; k < hulled.parts.size(); ++k) {
    const ConvexHull& hull = hulled.hulls[k];
    const SurfaceIndex surface(hull.points, hull.facets);
    ASSERT_EQ(result.map.images[k].size(), hulled.parts[k].mesh.points().size());
    for (const Vec3& image : result.map.images[k])
      ASSERT_LT(surface.closest(image).distance, 1e-12 * hulled.model.mesh.diagonal());
  }
}

TEST(MapToHull, AConvexPartStaysNearWhereItIs) {
  const TriMesh mesh = tests::sphere(8);
  for (const HullMapMethod method : kMethods) {
    const MappedToHull result = mapped(whole(mesh), method);
    EXPECT_EQ(result.reports[0].folds, 0);
    EXPECT_NEAR(result.reports[0].degree, 1, 1e-9);
    EXPECT_TRUE(result.reports[0].one_to_one);
    EXPECT_LT(largest_distance(result.map.images[0], mesh.points()),
              method == HullMapMethod::lifted ? 0.04 : 0.03);
  }
}

/// A coarse shape with every facet cut in 4^rounds: its hull has slivers, as rounding puts middles of edges a
/// little outside.
TriMesh with_flat_sides(int rounds) {
  TriMesh mesh = tests::sphere(1);
  Points points = mesh.points();
  for (Vec3& p : points)
    p = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()) * (p + 0.1 * p.cwiseProduct(p));
  mesh = mesh.with_points(points);
  for (; rounds > 0; --rounds) {
    const SplitMesh split = split_chords(mesh, std::vector<bool>(mesh.vertex_count(), true), {});
    mesh = split.mesh;
  }
  return mesh;
}

TEST(MapToHull, FlatSidesWithSliversInTheHull) {
  for (const int rounds : {1, 3, 4}) {
    const HulledModel hulled = whole(with_flat_sides(rounds));
    for (const HullMapMethod method : {HullMapMethod::progressive, HullMapMethod::lifted}) {
      const MappedToHull result = mapped(hulled, method);
      EXPECT_TRUE(result.reports[0].one_to_one);
      EXPECT_EQ(result.reports[0].method, method) << result.reports[0].remark;
      expect_on_hull(hulled, result);
    }
  }
}

double smallest_angle(const TriMesh& mesh) {
  double smallest = M_PI;
  for (const Facet& f : mesh.facets()) {
    for (int i = 0; i < 3; ++i) {
      const Vec3 a = mesh.point(f[(i + 1) % 3]) - mesh.point(f[i]),
                 b = mesh.point(f[(i + 2) % 3]) - mesh.point(f[i]);
      smallest = std::min(smallest, std::atan2(a.cross(b).norm(), a.dot(b)));
    }
  }
  return smallest;
}

TEST(MapToHull, SliversAndTinyOpeningsAreOneToOne) {
  constexpr double kTiny = 1e-6;
  for (const TriMesh& shape : {tests::cube(4), tests::bumpy_sphere(4, 0.5)}) {
    for (const TriMesh& mesh : {tests::with_needles(tests::with_flat_slivers(shape, 3, kTiny), 5, kTiny),
                                tests::with_opening(shape, {0.2, 0.3, 1}, kTiny)}) {
      ASSERT_LT(smallest_angle(mesh), 4 * kTiny);
      for (const HulledModel& hulled : {whole(mesh), halves(mesh)}) {
        const MappedToHull result = mapped(hulled, HullMapMethod::progressive);
        expect_on_hull(hulled, result);
        for (const PartMapReport& report : result.reports) {
          EXPECT_TRUE(report.one_to_one) << report.folds << " folds";
          EXPECT_EQ(report.method, HullMapMethod::progressive) << report.remark;
          EXPECT_LT(report.distortion, 2.5);
        }
      }
    }
  }
}

TEST(MapToHull, ImagesLieOnTheHullAlsoOfParts) {
  for (const TriMesh& mesh : {tests::capsule(3, 16, 24), tests::bumpy_sphere(8, 0.5)}) {
    for (const HullMapMethod method : kMethods) {
      const HulledModel hulled = halves(mesh);
      const MappedToHull result = mapped(hulled, method);
      expect_on_hull(hulled, result);
      for (const PartMapReport& report : result.reports) {
        EXPECT_EQ(report.method, method);
        EXPECT_TRUE(report.remark.empty());
        EXPECT_TRUE(report.one_to_one) << report.folds << " folds";
      }
    }
  }
}

TEST(MapToHull, TheUniformLaplacianGivesAnotherMap) {
  const HulledModel hulled = halves(tests::capsule(3, 16, 24));
  MapToHullOptions uniform;
  uniform.method = HullMapMethod::energy;
  uniform.energy.laplacian = LaplacianKind::uniform;
  const MappedToHull by_uniform = map_to_hull(hulled, uniform);
  const MappedToHull by_mean_value = mapped(hulled, HullMapMethod::energy);
  expect_on_hull(hulled, by_uniform);
  EXPECT_GT(largest_distance(by_uniform.map.images[0], by_mean_value.map.images[0]), 1e-3);
}

TEST(MapToHull, ClosestPointFittingFoldsWhereNormalsDoNot) {
  // A hollow whose bottom is as near to one side of the hull as to the other.
  const HulledModel hulled = whole(tests::bumpy_sphere(16, 0.8));
  MapToHullOptions closest;
  closest.method = HullMapMethod::energy;
  closest.energy.fitting = HullFitting::closest_point;
  closest.energy.last_convex_weight = 1;
  MapToHullOptions normal = closest;
  normal.energy.fitting = HullFitting::normal;
  const MappedToHull by_closest = map_to_hull(hulled, closest), by_normal = map_to_hull(hulled, normal);
  expect_on_hull(hulled, by_closest);
  EXPECT_GT(largest_distance(by_closest.map.images[0], by_normal.map.images[0]), 1e-3);
  EXPECT_LE(by_normal.reports[0].folds_before, by_closest.reports[0].folds_before);
}

TEST(MapToHull, TheConvexTermDrawsThePartOntoItsHull) {
  const HulledModel hulled = whole(tests::bumpy_sphere(8, 0.5));
  MapToHullOptions without;
  without.method = HullMapMethod::energy;
  without.energy.global_weight = 1e6;  // the hull's own vertices stay in place, what moves are the others
  without.energy.steps = 0;
  MapToHullOptions strong = without;
  strong.energy.steps = 10;
  strong.energy.last_convex_weight = 1;
  const double before = map_to_hull(hulled, without).reports[0].off_hull;
  EXPECT_LT(map_to_hull(hulled, strong).reports[0].off_hull, 0.2 * before);
}

TEST(MapToHull, FollowsSimilarities) {
  const TriMesh mesh = irregular();
  const double scale = 1000;
  // A turn that permutes the axes: the diagonal l, to which d_i is relative, is that of the bounding box.
  const Eigen::Matrix3d turn = (Eigen::Matrix3d() << 0, 0, 1, 1, 0, 0, 0, 1, 0).finished();
  const Vec3 shift(5, -7, 11);
  Points moved;
  for (const Vec3& p : mesh.points()) moved.push_back(scale * (turn * p) + shift);
  for (const HullMapMethod method : kMethods) {
    const MappedToHull before = mapped(whole(mesh), method);
    const MappedToHull after = mapped(whole(mesh.with_points(moved)), method);
    EXPECT_EQ(after.reports[0].folds, before.reports[0].folds);
    if (method == HullMapMethod::progressive) {
      // The order of collapses decides between equals here; what must agree is the quality.
      EXPECT_NEAR(after.reports[0].distortion, before.reports[0].distortion, 0.02);
      continue;
    }
    Points expected;
    for (const Vec3& image : before.map.images[0]) expected.push_back(scale * (turn * image) + shift);
    EXPECT_LT(largest_distance(after.map.images[0], expected), 1e-6 * scale);
  }
}

TEST(MapToHull, TheEnergyDoesNotDependOnTheOrderOfVertices) {
  const TriMesh mesh = irregular();
  std::vector<int> renumbered(mesh.vertex_count());
  std::iota(renumbered.begin(), renumbered.end(), 0);
  std::shuffle(renumbered.begin(), renumbered.end(), std::mt19937(3));
  Points points(mesh.vertex_count());
  for (int v = 0; v < mesh.vertex_count(); ++v) points[renumbered[v]] = mesh.point(v);
  Facets facets;
  for (const auto& [a, b, c] : mesh.facets()) facets.push_back({renumbered[b], renumbered[c], renumbered[a]});
  const MappedToHull before = mapped(whole(mesh), HullMapMethod::energy);
  const MappedToHull after = mapped(whole(TriMesh(points, facets)), HullMapMethod::energy);
  Points expected(mesh.vertex_count());
  for (int v = 0; v < mesh.vertex_count(); ++v) expected[renumbered[v]] = before.map.images[0][v];
  EXPECT_LT(largest_distance(after.map.images[0], expected), 1e-9);
}

TEST(MapToHull, GivesTheSameBytesOnEachRun) {
  const HulledModel hulled = halves(tests::capsule(3, 16, 24));
  for (const HullMapMethod method : kMethods) {
    EXPECT_EQ(mapped(hulled, method).map.images, mapped(hulled, method).map.images);
  }
}

TEST(MapToHull, APartWithAHandleIsMappedByTheEnergyAndSaysSo) {
  const HulledModel hulled = whole(tests::torus(2, 0.7, 24, 12));
  const MappedToHull result = mapped(hulled, HullMapMethod::progressive);
  EXPECT_EQ(result.reports[0].method, HullMapMethod::energy);
  EXPECT_NE(result.reports[0].remark.find("1 handle"), std::string::npos);
  EXPECT_FALSE(result.reports[0].one_to_one);
  expect_on_hull(hulled, result);
}

}  // namespace
}  // namespace partwise
