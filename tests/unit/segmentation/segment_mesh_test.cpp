#include "segmentation/segment_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "builders.h"
#include "error.h"
#include "segmentation/landmarks.h"
#include "segmentation/sketches.h"

namespace partwise {
namespace {

using tests::body_sketch;
using tests::part_at;

Sketch with_vertices(Sketch sketch, const std::vector<int>& new_vertex) {
  for (SketchedPart& part : sketch.parts) {
    for (Stroke& stroke : part.strokes) {
      for (int& v : std::get<VertexStroke>(stroke).vertices) v = new_vertex[v];
    }
  }
  for (SketchedMarker& marker : sketch.markers) marker.place = new_vertex[std::get<int>(marker.place)];
  for (SketchedAnchor& anchor : sketch.anchors) anchor.place = new_vertex[std::get<int>(anchor.place)];
  return sketch;
}

std::string complaint(const TriMesh& mesh, const Sketch& sketch) {
  try {
    segment_mesh(mesh, sketch, {});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

class BothMethods : public testing::TestWithParam<SegmentationMethod> {
 protected:
  SegmentationOptions options() const {
    SegmentationOptions result;
    result.method = GetParam();
    return result;
  }
};
INSTANTIATE_TEST_SUITE_P(SegmentMesh, BothMethods,
                         testing::Values(SegmentationMethod::walker, SegmentationMethod::growth));

TEST_P(BothMethods, LabelsDoNotChangeWithScaleRotationAndNumbering) {
  const TriMesh body = tests::irregular_body();
  const Sketch sketch = body_sketch(body);
  const SegmentedMesh plain = segment_mesh(body, sketch, options());
  const std::vector<int>& labels = plain.model.segmentation.labels;
  for (int part = 0; part < 3; ++part) EXPECT_GT(std::count(labels.begin(), labels.end(), part), 20);

  const Eigen::AngleAxisd turn(1.1, Vec3(1, 2, 3).normalized());
  for (const double scale : {1000.0, 0.001}) {
    Points points;
    for (const Vec3& p : body.points()) points.push_back(scale * (turn * p) + scale * Vec3(5, -7, 1));
    const SegmentedMesh moved = segment_mesh(body.with_points(points), sketch, options());
    EXPECT_EQ(moved.model.segmentation.labels, labels);
    EXPECT_EQ(moved.model.anchors[0].vertex, plain.model.anchors[0].vertex);
    const auto depth = [](const SegmentedModel& m) { return m.concavity[0].largest * m.mesh.diagonal(); };
    EXPECT_NEAR(depth(moved.model) / scale, depth(plain.model), 1e-9);
  }
  const tests::Renumbered other = tests::renumbered(body, 5);
  const SegmentedMesh same = segment_mesh(other.mesh, with_vertices(sketch, other.new_vertex), options());
  for (int f = 0; f < body.facet_count(); ++f) {
    ASSERT_EQ(same.model.segmentation.labels[other.new_facet[f]], labels[f]) << "facet " << f;
  }
  EXPECT_EQ(same.model.anchors[0].vertex, other.new_vertex[plain.model.anchors[0].vertex]);
}

TEST_P(BothMethods, CutACapsuleAtItsWaist) {
  const TriMesh mesh = tests::capsule(4, 24, 48);
  Sketch sketch;
  sketch.parts = {part_at(mesh, "south", {{0, 0, -3}, {1, 0, -2}}),
                  part_at(mesh, "north", {{0, 0, 3}, {1, 0, 2}})};
  sketch.anchors = {{"a", {"north", "south"}, Vec3(1, 0, 0)}, {"b", {"north", "south"}, Vec3(1, 0, 0)}};
  SegmentationOptions snapping = options();
  snapping.snap_limit = 0.2;
  const SegmentedMesh cut = segment_mesh(mesh, sketch, snapping);
  ASSERT_EQ(cut.model.segmentation.curves.size(), 1U);
  EXPECT_TRUE(cut.model.segmentation.curves[0].closed);
  for (const int v : cut.model.segmentation.curves[0].vertices) EXPECT_LT(std::abs(mesh.point(v).z()), 1);
  EXPECT_NE(cut.model.anchors[0].vertex, cut.model.anchors[1].vertex);
  EXPECT_LE(cut.model.anchors[0].snap_distance, cut.model.anchors[1].snap_distance);
  EXPECT_TRUE(cut.warnings.empty());
}

TEST_P(BothMethods, CutMeshesWithBoundaryAndOfGenusOne) {
  const TriMesh cap = tests::hemisphere(16);
  Sketch halves;
  halves.parts = {part_at(cap, "left", {{-1, 0, 0}, {-0.5, 0, 0.8}}),
                  part_at(cap, "right", {{1, 0, 0}, {0.5, 0, 0.8}})};
  const Segmentation open = segment_mesh(cap, halves, options()).model.segmentation;
  EXPECT_EQ(open.curves.size(), 3U);  // one between the halves, one to the outside each
  EXPECT_EQ(open.cross_points.size(), 2U);

  const TriMesh ring = tests::torus(3, 1, 40, 16);
  auto arc = [](double from, double to) {
    std::vector<Vec3> places;
    for (double u = from; u <= to; u += 0.2) {
      for (const double side : {-1.0, 1.0}) places.emplace_back(3 * std::cos(u), 3 * std::sin(u), side);
    }
    return places;
  };
  Sketch arcs;
  arcs.parts = {part_at(ring, "left", arc(0.3, 2.8)), part_at(ring, "right", arc(3.5, 5.9))};
  EXPECT_EQ(segment_mesh(ring, arcs, options()).model.segmentation.curves.size(), 2U);
}

TEST(SegmentMesh, WithoutPartsTheWholeMeshIsOne) {
  const TriMesh mesh = tests::bumpy_sphere(8, 0.3);
  Sketch sketch;
  sketch.markers = {{"m", SurfacePoint{3, Vec3(0.25, 0.25, 0.5)}}};
  const SegmentedMesh whole = segment_mesh(mesh, sketch, {});
  EXPECT_EQ(whole.model.segmentation.names, (std::vector<std::string>{"whole"}));
  EXPECT_TRUE(whole.model.segmentation.curves.empty());
  EXPECT_EQ(whole.model.markers[0].point.facet, 3);
  EXPECT_GT(whole.model.concavity[0].largest, 0.005);
  sketch.parts = {{"ball", {}}};
  EXPECT_EQ(segment_mesh(mesh, sketch, {}).model.segmentation.names, (std::vector<std::string>{"ball"}));
}

TEST(SegmentMesh, HintsToDecomposeConcaveParts) {
  const TriMesh mesh = tests::bumpy_sphere(8, 0.3);
  SegmentationOptions strict;
  strict.tau = 0.005;
  const SegmentedMesh whole = segment_mesh(mesh, {}, strict);
  ASSERT_EQ(whole.warnings.size(), 1U);
  const std::string vertex = std::to_string(whole.model.concavity[0].vertex);
  EXPECT_NE(whole.warnings[0].find("part 'whole': decompose further near vertex " + vertex),
            std::string::npos);
}

TEST(SegmentMesh, SaysWhichEntryDoesNotFitTheMesh) {
  const TriMesh body = tests::irregular_body();
  Sketch sketch = body_sketch(body);
  std::get<VertexStroke>(sketch.parts[1].strokes[0]).vertices[1] = 99999;
  EXPECT_EQ(complaint(body, sketch),
            "part 'top', stroke 0, entry 1: there is no vertex 99999; the mesh has 1602 (0 to 1601); "
            "is this the sketch of another mesh?");
  sketch = body_sketch(body);
  sketch.parts[0].strokes.emplace_back(PointStroke{{{0, 0, -1.7}, {0, 0, -17}}});
  EXPECT_NE(complaint(body, sketch).find("part 'bottom', stroke 1, entry 1: the point lies"),
            std::string::npos);
  sketch = body_sketch(body);
  sketch.markers.push_back({"far", SurfacePoint{4000, Vec3(1, 0, 0)}});
  EXPECT_EQ(complaint(body, sketch), "marker 'far': there is no facet 4000; the mesh has 3200");
  sketch = body_sketch(body);
  sketch.mesh = SketchedMesh{5, 6};
  EXPECT_NE(complaint(body, sketch).find("drawn for a mesh of 5 vertices and 6 facets"), std::string::npos);
}

TEST(SegmentMesh, RefusesAnchorsBetweenPartsThatDoNotMeet) {
  const TriMesh mesh = tests::capsule(6, 24, 60);
  Sketch sketch;
  sketch.parts = {part_at(mesh, "south", {{0, 0, -4}}), part_at(mesh, "middle", {{1, 0, 0}, {-1, 0, 0}}),
                  part_at(mesh, "north", {{0, 0, 4}})};
  sketch.anchors = {{"x", {"south", "north"}, 0}};
  EXPECT_NE(complaint(mesh, sketch).find("anchor 'x': the parts 'south' and 'north' share no boundary"),
            std::string::npos);
}

TEST(SegmentMesh, APointsStrokeIsTheStrokeOfTheNearestVertices) {
  const TriMesh body = tests::irregular_body();
  const Sketch by_vertices = body_sketch(body);
  Sketch by_points = by_vertices;
  for (SketchedPart& part : by_points.parts) {
    PointStroke points;
    for (const int v : std::get<VertexStroke>(part.strokes[0]).vertices) {
      points.points.push_back(body.point(v) * 1.001);
    }
    std::reverse(points.points.begin(), points.points.end());
    points.points.push_back(points.points.front());  // order and repetition mean nothing
    part.strokes[0] = points;
  }
  EXPECT_EQ(segment_mesh(body, by_points, {}).model.segmentation.labels,
            segment_mesh(body, by_vertices, {}).model.segmentation.labels);
}

TEST(Landmarks, PartsAtAPointAreThoseOfEveryFacetThatContainsIt) {
  const TriMesh mesh = tests::grid(2);
  const Segmentation halves = trace_boundaries(mesh, {"a", "b"}, {0, 0, 0, 0, 1, 1, 1, 1});
  const auto place = [&](double x, double y, double z) { return SurfacePoint{2, Vec3(x, y, z)}; };
  // Facet 2 is (1, 4, 5); edge (4, 5) lies on the boundary between the halves.
  ASSERT_EQ(mesh.facet(2), (Facet{1, 4, 5}));
  EXPECT_EQ(parts_at(mesh, halves, place(0.2, 0.4, 0.4)), (std::vector<int>{0}));
  EXPECT_EQ(parts_at(mesh, halves, place(0, 0.5, 0.5)), (std::vector<int>{0, 1}));
  EXPECT_EQ(parts_at(mesh, halves, place(0, 1, 0)), (std::vector<int>{0, 1}));
  EXPECT_EQ(parts_at(mesh, halves, place(0.5, 0.5, 0)), (std::vector<int>{0}));
  EXPECT_EQ(parts_at(mesh, halves, place(1, 0, 0)), (std::vector<int>{0}));
}

}  // namespace
}  // namespace partwise
