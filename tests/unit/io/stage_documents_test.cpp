#include "io/stage_documents.h"

#include <gtest/gtest.h>

#include <bit>
#include <sstream>

#include "builders.h"
#include "error.h"
#include "stage_samples.h"

namespace partwise::io {
namespace {

/// The document after a trip through bytes, as a file or a pipe would carry it.
Document through_bytes(const Document& document) {
  std::stringstream stream;
  write_ply(stream, document.tables);
  return {read_ply(stream), Json::parse(document.metadata.dump())};
}

/// Doubles as bits: 0 and -0 differ.
std::vector<std::uint64_t> bits(const Points& points) {
  std::vector<std::uint64_t> result;
  for (const Vec3& point : points) {
    for (const double coordinate : point) result.push_back(std::bit_cast<std::uint64_t>(coordinate));
  }
  return result;
}

void expect_equal(const TriMesh& a, const TriMesh& b) {
  EXPECT_EQ(bits(a.points()), bits(b.points()));
  EXPECT_EQ(a.facets(), b.facets());
}

void expect_equal(const SurfacePoint& a, const SurfacePoint& b) {
  EXPECT_EQ(a.facet, b.facet);
  EXPECT_EQ(bits({a.barycentric}), bits({b.barycentric}));
}

void expect_equal(const Segmentation& a, const Segmentation& b) {
  EXPECT_EQ(a.names, b.names);
  EXPECT_EQ(a.labels, b.labels);
  ASSERT_EQ(a.curves.size(), b.curves.size());
  for (std::size_t i = 0; i < a.curves.size(); ++i) {
    EXPECT_EQ(a.curves[i].left, b.curves[i].left);
    EXPECT_EQ(a.curves[i].right, b.curves[i].right);
    EXPECT_EQ(a.curves[i].closed, b.curves[i].closed);
    EXPECT_EQ(a.curves[i].vertices, b.curves[i].vertices);
    EXPECT_EQ(a.curves[i].length, b.curves[i].length);
  }
  ASSERT_EQ(a.cross_points.size(), b.cross_points.size());
  for (std::size_t i = 0; i < a.cross_points.size(); ++i) {
    EXPECT_EQ(a.cross_points[i].vertex, b.cross_points[i].vertex);
    EXPECT_EQ(a.cross_points[i].parts, b.cross_points[i].parts);
  }
}

void expect_equal(const SegmentedModel& a, const SegmentedModel& b) {
  expect_equal(a.mesh, b.mesh);
  expect_equal(a.segmentation, b.segmentation);
  ASSERT_EQ(a.markers.size(), b.markers.size());
  for (std::size_t i = 0; i < a.markers.size(); ++i) {
    EXPECT_EQ(a.markers[i].name, b.markers[i].name);
    expect_equal(a.markers[i].point, b.markers[i].point);
  }
  ASSERT_EQ(a.anchors.size(), b.anchors.size());
  for (std::size_t i = 0; i < a.anchors.size(); ++i) {
    EXPECT_EQ(a.anchors[i].name, b.anchors[i].name);
    EXPECT_EQ(a.anchors[i].part_a, b.anchors[i].part_a);
    EXPECT_EQ(a.anchors[i].part_b, b.anchors[i].part_b);
    EXPECT_EQ(a.anchors[i].vertex, b.anchors[i].vertex);
    EXPECT_EQ(a.anchors[i].snap_distance, b.anchors[i].snap_distance);
    EXPECT_EQ(a.anchors[i].proposed, b.anchors[i].proposed);
  }
  ASSERT_EQ(a.concavity.size(), b.concavity.size());
  for (std::size_t i = 0; i < a.concavity.size(); ++i) {
    EXPECT_EQ(a.concavity[i].largest, b.concavity[i].largest);
    EXPECT_EQ(a.concavity[i].mean, b.concavity[i].mean);
    EXPECT_EQ(a.concavity[i].vertex, b.concavity[i].vertex);
  }
}

void expect_equal(const std::vector<Part>& a, const std::vector<Part>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].index, b[k].index);
    expect_equal(a[k].mesh, b[k].mesh);
    EXPECT_EQ(a[k].model_vertex, b[k].model_vertex);
    EXPECT_EQ(a[k].model_facet, b[k].model_facet);
    EXPECT_EQ(a[k].loops, b[k].loops);
    EXPECT_EQ(a[k].cap_vertices, b[k].cap_vertices);
  }
}

void expect_equal(const HulledModel& a, const HulledModel& b) {
  expect_equal(a.model, b.model);
  expect_equal(a.parts, b.parts);
  ASSERT_EQ(a.hulls.size(), b.hulls.size());
  for (std::size_t k = 0; k < a.hulls.size(); ++k) {
    EXPECT_EQ(bits(a.hulls[k].points), bits(b.hulls[k].points));
    EXPECT_EQ(a.hulls[k].facets, b.hulls[k].facets);
    EXPECT_EQ(a.hulls[k].part_vertex, b.hulls[k].part_vertex);
  }
}

void expect_equal(const std::vector<Points>& a, const std::vector<Points>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_EQ(bits(a[k]), bits(b[k]));
}

void expect_equal(const HullMap& a, const HullMap& b) {
  expect_equal(a.hulled, b.hulled);
  expect_equal(a.images, b.images);
}

void expect_equal(const std::vector<MarkerPair>& a, const std::vector<MarkerPair>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].name, b[i].name);
    expect_equal(a[i].source, b[i].source);
    expect_equal(a[i].target, b[i].target);
  }
}

void expect_equal(const CrossMap& a, const CrossMap& b) {
  expect_equal(a.source, b.source);
  expect_equal(a.target, b.target);
  expect_equal(a.source_parts, b.source_parts);
  expect_equal(a.images, b.images);
  expect_equal(a.markers, b.markers);
  ASSERT_EQ(a.boundary.size(), b.boundary.size());
  for (std::size_t i = 0; i < a.boundary.size(); ++i) {
    EXPECT_EQ(a.boundary[i].source_vertex, b.boundary[i].source_vertex);
    EXPECT_EQ(a.boundary[i].target_a, b.boundary[i].target_a);
    EXPECT_EQ(a.boundary[i].target_b, b.boundary[i].target_b);
    EXPECT_EQ(a.boundary[i].fraction, b.boundary[i].fraction);
  }
}

void expect_equal(const CompatibleMesh& a, const CompatibleMesh& b) {
  expect_equal(a.source, b.source);
  expect_equal(a.target, b.target);
  EXPECT_EQ(bits(a.points), bits(b.points));
  ASSERT_EQ(a.map.images().size(), b.map.images().size());
  for (std::size_t v = 0; v < a.map.images().size(); ++v) {
    expect_equal(a.map.images()[v], b.map.images()[v]);
  }
  EXPECT_EQ(bits(a.map.positions(a.target)), bits(b.map.positions(b.target)));
  EXPECT_EQ(a.source_labels, b.source_labels);
  EXPECT_EQ(a.target_labels, b.target_labels);
  EXPECT_EQ(a.part_names, b.part_names);
  expect_equal(a.markers, b.markers);
  ASSERT_EQ(a.critical_points.size(), b.critical_points.size());
  for (std::size_t i = 0; i < a.critical_points.size(); ++i) {
    EXPECT_EQ(a.critical_points[i].vertex, b.critical_points[i].vertex);
    EXPECT_EQ(a.critical_points[i].curvature, b.critical_points[i].curvature);
    EXPECT_EQ(a.critical_points[i].region, b.critical_points[i].region);
    EXPECT_EQ(a.critical_points[i].radius, b.critical_points[i].radius);
  }
  EXPECT_EQ(a.refinement.original_facets, b.refinement.original_facets);
  EXPECT_EQ(a.refinement.parent_facet, b.refinement.parent_facet);
  ASSERT_EQ(a.refinement.vertices.size(), b.refinement.vertices.size());
  for (std::size_t i = 0; i < a.refinement.vertices.size(); ++i) {
    expect_equal(a.refinement.vertices[i], b.refinement.vertices[i]);
  }
}

TEST(StageDocuments, MeshSurvives) {
  Points points = tests::sphere(3).points();
  points[0] = Vec3(0.1, -0.0, 1e-310);
  const TriMesh mesh = tests::sphere(3).with_points(points);
  const Document document = through_bytes(to_document(mesh));
  EXPECT_EQ(document.metadata["schema"], "partwise/mesh-1");
  expect_equal(read_mesh(document), mesh);
}

TEST(StageDocuments, SegmentedModelSurvives) {
  const SegmentedModel model = tests::sample_segmented_model();
  ASSERT_FALSE(model.segmentation.cross_points.empty());
  const Document document = through_bytes(to_document(model));
  EXPECT_EQ(document.metadata["schema"], "partwise/segment-1");
  expect_equal(read_segmented_model(document), model);
}

TEST(StageDocuments, OpenModelSurvives) {
  const SegmentedModel model = tests::sample_open_model();
  expect_equal(read_segmented_model(through_bytes(to_document(model))), model);
}

TEST(StageDocuments, OnePartSurvives) {
  const TriMesh mesh = tests::cube(2);
  const SegmentedModel model{
      mesh, trace_boundaries(mesh, {"all"}, std::vector<int>(mesh.facet_count(), 0)), {}, {}, {}};
  expect_equal(read_segmented_model(through_bytes(to_document(model))), model);
}

TEST(StageDocuments, HulledModelSurvives) {
  const HulledModel hulled = tests::sample_hulled_model();
  const Document document = through_bytes(to_document(hulled));
  EXPECT_EQ(document.metadata["schema"], "partwise/hull-1");
  expect_equal(read_hulled_model(document), hulled);
}

TEST(StageDocuments, HullMapSurvives) {
  const HullMap map = tests::sample_hull_map();
  const Document document = through_bytes(to_document(map));
  EXPECT_EQ(document.metadata["schema"], "partwise/hullmap-1");
  expect_equal(read_hull_map(document), map);
}

TEST(StageDocuments, CrossMapSurvives) {
  const CrossMap map = tests::sample_cross_map();
  ASSERT_NE(map.source_parts.front().index, 0);
  const Document document = through_bytes(to_document(map));
  EXPECT_EQ(document.metadata["schema"], "partwise/crossmap-1");
  expect_equal(read_cross_map(document), map);
}

TEST(StageDocuments, CompatibleMeshSurvives) {
  const CompatibleMesh mesh = tests::sample_compatible_mesh();
  const Document document = through_bytes(to_document(mesh));
  EXPECT_EQ(document.metadata["schema"], "partwise/compatible-1");
  expect_equal(read_compatible_mesh(document), mesh);
}

TEST(StageDocuments, RefinedMeshSurvives) {
  const CompatibleMesh mesh = tests::sample_refined_mesh();
  ASSERT_EQ(mesh.refinement.vertices.size(), 4U);
  const Document document = through_bytes(to_document(mesh));
  EXPECT_EQ(document.metadata["refined_vertices"], 4);
  expect_equal(read_compatible_mesh(document), mesh);
}

TEST(StageDocuments, ARefinedMeshThatIsNotTheOriginalSurfaceIsRefused) {
  CompatibleMesh mesh = tests::sample_refined_mesh();
  std::swap(mesh.refinement.parent_facet.front(), mesh.refinement.parent_facet.back());
  EXPECT_THROW(read_compatible_mesh(to_document(mesh)), InputError);
  mesh = tests::sample_refined_mesh();
  mesh.refinement.vertices[0].barycentric = Vec3(1, 0, 0);
  EXPECT_THROW(read_compatible_mesh(to_document(mesh)), InputError);
}

TEST(StageDocuments, WritingWhatWasReadGivesTheSameDocument) {
  const Document document = to_document(tests::sample_cross_map());
  const Document again = to_document(read_cross_map(document));
  std::ostringstream a, b;
  write_ply(a, document.tables);
  write_ply(b, again.tables);
  EXPECT_EQ(a.str(), b.str());
  EXPECT_EQ(document.metadata, again.metadata);
}

TEST(StageDocuments, OwnGeometryOfEveryKindIsAMesh) {
  EXPECT_EQ(read_mesh(to_document(tests::sample_segmented_model())).facet_count(), 8 * 16);
  const HullMap map = tests::sample_hull_map();
  int facets = 0;
  for (const Part& part : map.hulled.parts) facets += part.mesh.facet_count();
  EXPECT_EQ(read_mesh(to_document(map.hulled)).facet_count(), facets);
  EXPECT_EQ(read_mesh(to_document(map)).facet_count(), facets);
  const CompatibleMesh compatible = tests::sample_compatible_mesh();
  EXPECT_EQ(read_mesh(to_document(compatible)).facets(), compatible.source.facets());
}

TEST(StageDocuments, OtherKindIsRefusedByName) {
  const Document mesh = to_document(tests::tetrahedron());
  EXPECT_THROW(read_segmented_model(mesh), InputError);
  EXPECT_THROW(read_hull_map(mesh), InputError);
  EXPECT_THROW(read_cross_map(mesh), InputError);
  EXPECT_THROW(read_compatible_mesh(mesh), InputError);
}

}  // namespace
}  // namespace partwise::io
