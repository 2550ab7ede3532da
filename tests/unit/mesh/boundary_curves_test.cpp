#include <gtest/gtest.h>

#include <cmath>

#include "builders.h"
#include "error.h"
#include "mesh/segmentation.h"

namespace partwise {
namespace {

double signed_height(const TriMesh& mesh, int facet, int axis) {
  const Facet& f = mesh.facet(facet);
  return mesh.point(f[0])[axis] + mesh.point(f[1])[axis] + mesh.point(f[2])[axis];
}

/// Labels a mesh by octants: bit k is set where coordinate k of the centroid is negative.
std::vector<int> octants(const TriMesh& mesh, int axes) {
  std::vector<int> labels;
  for (int f = 0; f < mesh.facet_count(); ++f) {
    int label = 0;
    for (int axis = 0; axis < axes; ++axis) label |= (signed_height(mesh, f, axis) < 0 ? 1 : 0) << axis;
    labels.push_back(label);
  }
  return labels;
}

TEST(BoundaryCurves, HalvesOfASphereShareOneClosedCurve) {
  const TriMesh mesh = tests::sphere(8);
  const Segmentation halves = trace_boundaries(mesh, {"front", "back"}, octants(mesh, 1));
  ASSERT_EQ(halves.curves.size(), 1U);
  const BoundaryCurve& curve = halves.curves.front();
  EXPECT_TRUE(curve.closed);
  EXPECT_EQ(curve.left, 0);
  EXPECT_EQ(curve.right, 1);
  EXPECT_EQ(curve.vertices.size(), 32U);
  EXPECT_NEAR(curve.length, 2 * std::acos(-1.0), 0.02);
  EXPECT_TRUE(halves.cross_points.empty());
  // Part 0 (x > 0) lies on the left: the curve runs counterclockwise seen from +x.
  const Vec3& a = mesh.point(curve.vertices[0]);
  const Vec3& b = mesh.point(curve.vertices[1]);
  EXPECT_GT(a.cross(b).x(), 0);
}

TEST(BoundaryCurves, OctantsOfASphereHaveSixCrossPointsAndTwelveArcs) {
  const TriMesh mesh = tests::sphere(6);
  const Segmentation octant =
      trace_boundaries(mesh, {"a", "b", "c", "d", "e", "f", "g", "h"}, octants(mesh, 3));
  EXPECT_EQ(octant.cross_points.size(), 6U);
  for (const CrossPoint& point : octant.cross_points) EXPECT_EQ(point.parts.size(), 4U);
  ASSERT_EQ(octant.curves.size(), 12U);
  for (const BoundaryCurve& curve : octant.curves) {
    EXPECT_FALSE(curve.closed);
    EXPECT_EQ(curve.vertices.size(), 7U);
  }
}

TEST(BoundaryCurves, TorusHalvesShareTwoCurves) {
  const TriMesh mesh = tests::torus(3, 1, 24, 10);
  const Segmentation halves = trace_boundaries(mesh, {"left", "right"}, octants(mesh, 1));
  EXPECT_EQ(halves.curves.size(), 2U);
}

TEST(BoundaryCurves, MeshBoundaryIsACurveToTheOutside) {
  const TriMesh mesh = tests::hemisphere(8);
  const Segmentation whole = trace_boundaries(mesh, {"cap"}, std::vector<int>(mesh.facet_count(), 0));
  ASSERT_EQ(whole.curves.size(), 1U);
  EXPECT_EQ(whole.curves.front().right, kOutside);
  const Segmentation halves = trace_boundaries(mesh, {"front", "back"}, octants(mesh, 1));
  EXPECT_EQ(halves.curves.size(), 3U);
  ASSERT_EQ(halves.cross_points.size(), 2U);
  for (const CrossPoint& point : halves.cross_points) {
    EXPECT_EQ(point.parts.front(), kOutside);
    EXPECT_EQ(point.parts.size(), 3U);
  }
}

TEST(BoundaryCurves, RefusesIslandsPinchesAndEmptyParts) {
  const TriMesh mesh = tests::sphere(8);
  std::vector<int> labels = octants(mesh, 1);
  EXPECT_THROW(trace_boundaries(mesh, {"front", "back", "nothing"}, labels), InputError);
  // Quadrants 0 and 3 of four together touch at two poles only.
  for (int& label : labels = octants(mesh, 2)) label = label == 0 || label == 3 ? 0 : 1;
  EXPECT_THROW(trace_boundaries(mesh, {"opposite", "others"}, labels), InputError);
  labels = octants(mesh, 1);
  int island = 0;  // the facet farthest from the boundary at x = 0
  for (int f = 0; f < mesh.facet_count(); ++f) {
    if (signed_height(mesh, f, 0) > signed_height(mesh, island, 0)) island = f;
  }
  labels[island] = 1;
  EXPECT_THROW(trace_boundaries(mesh, {"front", "back"}, labels), InputError);
}

}  // namespace
}  // namespace partwise
