#include "mapping/pin_on_hull.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "builders.h"
#include "geometry/convex_hull.h"
#include "mapping/release_markers.h"
#include "mapping/split_chords.h"
#include "mapping/untangle_on_hull.h"
#include "models.h"

namespace partwise {
namespace {

int count_folds(const TriMesh& mesh, const Points& images) {
  return static_cast<int>(std::count_if(mesh.facets().begin(), mesh.facets().end(), [&](const Facet& f) {
    return images[f[0]].dot((images[f[1]] - images[f[0]]).cross(images[f[2]] - images[f[0]])) <= 0;
  }));
}

class OnASphere : public testing::Test {
 protected:
  TriMesh mesh = tests::sphere(8);
  StarHull hull{convex_hull(mesh.points()), Vec3::Zero()};
  std::vector<double> weights = std::vector<double>(mesh.vertex_count(), 1.0);
};

TEST_F(OnASphere, UntanglesVerticesThrownOverTheirNeighbours) {
  Points start = mesh.points();
  for (int v = 0; v < mesh.vertex_count(); v += 7) start[v] = (start[v] + Vec3(0.5, -0.3, 0.4)).normalized();
  const UntangledMap untangled = untangle_on_hull(mesh, hull, start, {});
  EXPECT_EQ(untangled.folds_before, count_folds(mesh, start));
  EXPECT_GT(untangled.folds_before, 50);
  EXPECT_EQ(untangled.folds_after, 0);
  EXPECT_EQ(count_folds(mesh, untangled.images), 0);
}

TEST_F(OnASphere, UntanglingKeepsFixedVertices) {
  Points start = mesh.points();
  start[3] = (start[3] + Vec3(0.2, 0.2, -0.2)).normalized();
  std::vector<bool> fixed(mesh.vertex_count(), false);
  fixed[3] = true;
  const UntangledMap untangled = untangle_on_hull(mesh, hull, start, fixed);
  EXPECT_EQ(untangled.folds_after, 0);
  EXPECT_LT((untangled.images[3].normalized() - start[3]).norm(), 1e-12);
}

TEST(Untangling, DoesNotDependOnTheNumbering) {
  const TriMesh mesh = tests::lumpy_sphere(8);
  const int n = mesh.vertex_count();
  const StarHull hull(convex_hull(mesh.points()), Vec3::Zero());
  Points start = mesh.points(), reversed(n), reversed_start(n);
  for (int v = 0; v < n; v += 7) start[v] += Vec3(0.5, -0.3, 0.4);
  for (int v = 0; v < n; ++v) {
    reversed[n - 1 - v] = mesh.point(v);
    reversed_start[n - 1 - v] = start[v];
  }
  Facets facets;
  for (const auto& [a, b, c] : mesh.facets()) facets.push_back({n - 1 - b, n - 1 - c, n - 1 - a});
  const UntangledMap untangled = untangle_on_hull(mesh, hull, start, {});
  const UntangledMap other = untangle_on_hull(TriMesh(reversed, facets), hull, reversed_start, {});
  EXPECT_GT(untangled.folds_before, 50);
  EXPECT_EQ(untangled.folds_after, 0);
  for (int v = 0; v < n; ++v) EXPECT_LT((other.images[n - 1 - v] - untangled.images[v]).norm(), 1e-9) << v;
}

TEST_F(OnASphere, BringsPinsToTheirGoalsWithoutFolds) {
  // Every vertex of the equator goes on by a twelfth of a turn; one pole is pinned where it is.
  std::vector<Pin> pins;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(M_PI / 6, Vec3::UnitZ()).toRotationMatrix();
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const Vec3& p = mesh.point(v);
    if (std::abs(p.z()) < 1e-9) pins.push_back({v, hull.project(turn * p, 0).position});
    if (p.z() > 1 - 1e-9) pins.push_back({v, p});
  }
  ASSERT_EQ(pins.size(), 33U);
  const PinnedMap pinned = pin_on_hull(mesh, weights, hull, mesh.points(), pins, {});
  EXPECT_EQ(pinned.folds, 0);
  EXPECT_LT(pinned.pulled_distance, 1e-4);
  for (const Pin& pin : pins) EXPECT_EQ(pinned.images[pin.vertex], pin.goal);
  EXPECT_LT(pinned.distortion, 1.6);
}

TEST_F(OnASphere, ReleasesTheMarkerThatCannotBeReachedAndNoOther) {
  // The corners of a facet stay, but for one that should go to the other side of the edge between the others.
  const auto& [a, b, c] = mesh.facet(100);
  const int far = mesh.facet(300)[0];
  const Vec3 over = 0.7 * (mesh.point(b) + mesh.point(c)) - 0.4 * mesh.point(a);
  const std::vector<Pin> markers{
      {far, mesh.point(far)}, {b, mesh.point(b)}, {c, mesh.point(c)}, {a, hull.project(over, 0).position}};
  const MapWithMarkers map_with = [&](const std::vector<Pin>& held, const std::vector<Pin>& drawn) {
    PinOptions options;
    options.drawn = drawn;
    return pin_on_hull(mesh, weights, hull, mesh.points(), held, {}, options);
  };
  ASSERT_GT(map_with(markers, {}).folds, 0);
  const MarkedMap result =
      map_with_markers(markers, map_with, [](const PinnedMap& map) { return map.folds; });
  EXPECT_EQ(result.map.folds, 0);
  EXPECT_EQ(result.held, (std::vector<bool>{true, true, true, false}));
  for (std::size_t i = 0; i < markers.size(); ++i) {
    const double distance = (result.map.images[markers[i].vertex] - markers[i].goal).norm();
    if (result.held[i]) {
      EXPECT_EQ(distance, 0);
    } else {
      EXPECT_LT(distance, (mesh.point(markers[i].vertex) - markers[i].goal).norm());
    }
  }
}

TEST(ReleaseMarkers, HoldsTheInnocentAgain) {
  // 1 and 2 are guilty, but at first the fewest folds remain without 0.
  const std::vector<Pin> markers{
      {0, Vec3::UnitX()}, {1, Vec3::UnitY()}, {2, Vec3::UnitZ()}, {3, Vec3::UnitX()}};
  const MapWithMarkers map_with = [](const std::vector<Pin>& held, const std::vector<Pin>&) {
    auto holds = [&](int v) {
      return std::any_of(held.begin(), held.end(), [&](const Pin& pin) { return pin.vertex == v; });
    };
    PinnedMap map;
    map.images = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ(), Vec3::UnitX()};
    map.folds = !holds(1) && !holds(2) ? 0 : holds(0) ? 5 : holds(1) ? 3 : 2;
    return map;
  };
  const MarkedMap result =
      map_with_markers(markers, map_with, [](const PinnedMap& map) { return map.folds; });
  EXPECT_EQ(result.map.folds, 0);
  EXPECT_EQ(result.held, (std::vector<bool>{true, false, false, true}));
}

TEST(ReleaseMarkers, KeepsAllWhenReleasingDoesNotHelp) {
  const std::vector<Pin> markers{{0, Vec3::UnitX()}, {1, Vec3::UnitY()}};
  const MarkedMap result = map_with_markers(
      markers,
      [](const std::vector<Pin>&, const std::vector<Pin>&) {
        return PinnedMap{{Vec3::UnitX(), Vec3::UnitY()}, 5, 0, 0};
      },
      [](const PinnedMap& map) { return map.folds; });
  EXPECT_EQ(result.held, (std::vector<bool>{true, true}));
}

TEST(SplitChords, HalvesEdgesBetweenFixedVerticesOnly) {
  const TriMesh mesh = tests::grid(2);
  std::vector<bool> fixed(mesh.vertex_count(), true);
  fixed[4] = false;  // the middle
  std::vector<std::array<int, 2>> rim{{0, 1}, {1, 2}, {2, 5}, {5, 8}, {8, 7}, {7, 6}, {6, 3}, {3, 0}};
  const SplitMesh split = split_chords(mesh, fixed, rim);
  // Of the diagonals only those that miss the middle join two vertices of the rim.
  ASSERT_EQ(split.split_edges.size(), 2U);
  EXPECT_EQ(split.mesh.vertex_count(), mesh.vertex_count() + 2);
  EXPECT_EQ(split.mesh.facet_count(), mesh.facet_count() + 4);
  for (std::size_t i = 0; i < split.split_edges.size(); ++i) {
    const auto& [a, b] = split.split_edges[i];
    EXPECT_LT((split.mesh.points()[9 + i] - (mesh.point(a) + mesh.point(b)) / 2).norm(), 1e-15);
  }
}

TEST(SplitChords, CutsFacetsWithTwoAndThreeSuchEdges) {
  const TriMesh mesh = tests::tetrahedron();
  const SplitMesh split = split_chords(mesh, {true, true, true, false}, {{0, 1}});
  EXPECT_EQ(split.mesh.vertex_count(), 6);
  EXPECT_EQ(split.mesh.facet_count(), 3 + 2 + 2 + 1);
  EXPECT_EQ(split_chords(mesh, {true, true, true, true}, {}).mesh.facet_count(), 16);
}

}  // namespace
}  // namespace partwise
