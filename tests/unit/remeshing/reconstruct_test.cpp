#include "remeshing/reconstruct.h"

#include <gtest/gtest.h>

#include <cmath>

#include "builders.h"
#include "convex_pairs.h"
#include "error.h"
#include "geometry/surface_index.h"
#include "point_sets.h"

namespace partwise {
namespace {

using tests::largest_distance;

TEST(Reconstruct, OntoItselfIsTheModel) {
  for (const TriMesh& mesh : {tests::cube(4), tests::sphere(6), tests::bumpy_sphere(8, 0.3)}) {
    for (const SegmentedModel& model : {tests::whole(mesh), tests::halves(mesh)}) {
      const Reconstruction result = reconstruct(tests::projected_pair(model, model));
      EXPECT_LT(largest_distance(result.mesh.points, mesh.points()), 1e-12);
      EXPECT_EQ(result.metrics.ambiguous, 0);
      EXPECT_LT(result.metrics.boundary_gap_max, 1e-12);
      EXPECT_EQ(result.mesh.source_labels, model.segmentation.labels);
    }
  }
}

TEST(Reconstruct, OfASimilarModelIsTheSimilarity) {
  const TriMesh mesh = tests::bumpy_sphere(7, 0.3);
  Points moved;
  for (const Vec3& p : mesh.points()) moved.push_back(50 * Vec3(p.y(), p.z(), p.x()) + Vec3(1, 2, 3));
  const SegmentedModel source = tests::whole(mesh), target = tests::whole(mesh.with_points(moved));
  CrossMap map = tests::projected_pair(target, target);
  map.source = source;
  map.source_parts = {extract_part(source, 0)};
  EXPECT_LT(largest_distance(reconstruct(map).mesh.points, moved), 1e-10);
}

TEST(Reconstruct, PutsEveryVertexExactlyOnTheTarget) {
  const SegmentedModel source = tests::halves(tests::cube(6)),
                       target = tests::halves(tests::bumpy_sphere(10, 0.3));
  const CrossMap map = tests::projected_pair(source, target);
  for (const Coordinates mode : {Coordinates::facet, Coordinates::convex_hull, Coordinates::mean_value}) {
    const CompatibleMesh mesh = reconstruct(map, {.coordinates = mode}).mesh;
    const SurfaceIndex surface(target.mesh);
    for (int v = 0; v < source.mesh.vertex_count(); ++v) {
      EXPECT_EQ(mesh.points[v], position(mesh.target, mesh.map[v]));
      EXPECT_LT(surface.closest(mesh.points[v]).distance, 1e-15 * mesh.target.diagonal());
    }
  }
}

TEST(Reconstruct, KeepsBoundaryVerticesWhereTheyWerePlaced) {
  const SegmentedModel source = tests::halves(tests::cube(6)), target = tests::halves(tests::sphere(10));
  const CrossMap map = tests::projected_pair(source, target);
  ASSERT_EQ(map.boundary.size(), 24U);
  const CompatibleMesh mesh = reconstruct(map).mesh;
  for (const BoundaryPlacement& place : map.boundary) {
    const Vec3 a = target.mesh.point(place.target_a), b = target.mesh.point(place.target_b);
    EXPECT_NEAR((mesh.points[place.source_vertex] - (a + place.fraction * (b - a))).norm(), 0, 1e-15);
    EXPECT_EQ(mesh.points[place.source_vertex].z(), 0);
  }
}

TEST(Reconstruct, ReportsAGapBetweenPartsAndBoundary) {
  const SegmentedModel model = tests::halves(tests::sphere(8));
  CrossMap map = tests::projected_pair(model, model);
  const BoundaryPlacement place = map.boundary.front();
  const double edge = (model.mesh.point(place.target_b) - model.mesh.point(place.target_a)).norm();
  map.boundary.front().fraction = 1 - place.fraction;
  EXPECT_NEAR(reconstruct(map).metrics.boundary_gap_max, edge / model.mesh.diagonal(), 1e-12);
}

TEST(Reconstruct, KeepsSourceVerticesInTheirParts) {
  const SegmentedModel source = tests::halves(tests::sphere(7)), target = tests::halves(tests::cube(8));
  const CompatibleMesh mesh = reconstruct(tests::projected_pair(source, target)).mesh;
  for (int f = 0; f < source.mesh.facet_count(); ++f) {
    for (const int v : source.mesh.facet(f)) {
      if (mesh.source_labels[f] == 1) {
        EXPECT_GE(mesh.points[v].z(), 0);
      } else {
        EXPECT_LE(mesh.points[v].z(), 0);
      }
    }
  }
}

/// The two averaging modes are one by the coordinates' linear precision.
TEST(Reconstruct, AveragesAgree) {
  const CrossMap map =
      tests::projected_pair(tests::whole(tests::cube(5)), tests::whole(tests::bumpy_sphere(8, 0.2)));
  const Reconstruction hull = reconstruct(map, {.coordinates = Coordinates::convex_hull});
  const Reconstruction mean = reconstruct(map, {.coordinates = Coordinates::mean_value});
  EXPECT_LT(largest_distance(hull.mesh.points, mean.mesh.points), 1e-9);
  EXPECT_GT(hull.metrics.largest_projection, 0);
  EXPECT_LT(hull.metrics.largest_projection, 0.03);
}

TEST(Reconstruct, OfAFoldedTargetStaysNearTheNeighbours) {
  const SegmentedModel model = tests::whole(tests::sphere(12));
  CrossMap map = tests::projected_pair(model, model);
  // Folds the target's map: one vertex moves over its ring to the other side.
  const int folded = 100;
  const auto ring = model.mesh.half_edges().vv_range(OpenMesh::VertexHandle(folded));
  Points& images = map.target.images[0];
  images[folded] = (images[folded] + 2.5 * (images[ring.begin()->idx()] - images[folded])).normalized();
  const Reconstruction result = reconstruct(map);
  EXPECT_GT(result.metrics.ambiguous, 0);
  EXPECT_LT(largest_distance(result.mesh.points, model.mesh.points()), 0.3);
}

TEST(Reconstruct, HitsMarkersThatHullToHullPutInPlace) {
  const SegmentedModel model = tests::whole(tests::sphere(5));
  SurfacePoint goal{3, Vec3(1, 0, 0)};
  const CrossMap map = tests::projected_pair(model, model, {{"tip", goal, goal}});
  const CompatibleMesh mesh = reconstruct(map).mesh;
  EXPECT_EQ(mesh.points[model.mesh.facet(3)[0]], model.mesh.point(model.mesh.facet(3)[0]));
}

TEST(Reconstruct, RefusesAPlacementOffTheTargetsEdges) {
  const SegmentedModel model = tests::halves(tests::cube(4));
  CrossMap map = tests::projected_pair(model, model);
  const BoundaryPlacement good = map.boundary.front();
  int far = 0;
  while (model.mesh.point(far).z() < 1) ++far;
  map.boundary.front().target_b = far;
  EXPECT_THROW(reconstruct(map), InputError);
  map.boundary.front() = good;
  map.boundary.front().fraction = 1.5;
  EXPECT_THROW(reconstruct(map), InputError);
  map.boundary.front() = {good.source_vertex, good.target_a, good.target_a, 0};
  EXPECT_NO_THROW(reconstruct(map));
}

}  // namespace
}  // namespace partwise
