#include "segmentation/transfer_labels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "builders.h"
#include "error.h"
#include "geometry/normals.h"
#include "io/sketch.h"
#include "io/stage_documents.h"
#include "segmentation/compatibility.h"
#include "segmentation/sketches.h"

namespace partwise {
namespace {

using tests::body_sketch;
using tests::vertex_near;

/// Every facet cut into four at the midpoints of its edges: the same surface.
TriMesh subdivided(const TriMesh& mesh) {
  Points points = mesh.points();
  std::map<std::pair<int, int>, int> middle;
  auto between = [&](int a, int b) {
    const auto [entry, is_new] = middle.emplace(std::minmax(a, b), static_cast<int>(points.size()));
    if (is_new) points.push_back((mesh.point(a) + mesh.point(b)) / 2);
    return entry->second;
  };
  Facets facets;
  for (const auto& [a, b, c] : mesh.facets()) {
    const int ab = between(a, b), bc = between(b, c), ca = between(c, a);
    facets.insert(facets.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
  }
  return TriMesh(std::move(points), std::move(facets));
}

/// The surface with other triangles: subdivided, then every vertex slid along one of its edges.
TriMesh resampled(const TriMesh& mesh) {
  const TriMesh fine = subdivided(mesh);
  const HalfEdges& half_edges = fine.half_edges();
  Points points = fine.points();
  for (int v = 0; v < fine.vertex_count(); ++v) {
    Points ring;
    for (const auto w : half_edges.vv_range(OpenMesh::VertexHandle(v))) ring.push_back(fine.point(w.idx()));
    points[v] += 0.35 * (ring[v % ring.size()] - points[v]);
  }
  return fine.with_points(std::move(points));
}

double share_of_difference(const TriMesh& mesh, const std::vector<int>& a, const std::vector<int>& b) {
  const std::vector<double> areas = facet_areas(mesh.points(), mesh.facets());
  double total = 0, different = 0;
  for (std::size_t f = 0; f < areas.size(); ++f) {
    total += areas[f];
    if (a[f] != b[f]) different += areas[f];
  }
  return different / total;
}

TEST(TransferLabels, EqualConnectivityCopiesEverything) {
  const TriMesh body = tests::irregular_body();
  const SegmentedModel from = segment_mesh(body, body_sketch(body), {}).model;
  Points bent = body.points();
  for (Vec3& p : bent)
    p = Vec3(3 * p.x() + p.z() * p.z(), p.y(), 40 + p.z());  // far away: no place is looked up
  const TransferredSegmentation to = transfer_labels(body.with_points(bent), from, {}, {});
  EXPECT_TRUE(to.copied);
  EXPECT_EQ(to.moved_area, 0);
  const SegmentedModel& model = to.segmented.model;
  EXPECT_EQ(model.segmentation.labels, from.segmentation.labels);
  EXPECT_EQ(model.segmentation.names, from.segmentation.names);
  ASSERT_EQ(model.markers.size(), 1U);
  EXPECT_EQ(model.markers[0].point.facet, from.markers[0].point.facet);
  EXPECT_EQ(model.markers[0].point.barycentric, from.markers[0].point.barycentric);
  ASSERT_EQ(model.anchors.size(), 1U);
  EXPECT_EQ(model.anchors[0].vertex, from.anchors[0].vertex);
  EXPECT_EQ(model.anchors[0].name, "front");
  EXPECT_EQ(model.anchors[0].snap_distance, 0);
  // Of the bent shape, not of the one the labels come from.
  EXPECT_NE(model.concavity[0].largest, from.concavity[0].largest);
  EXPECT_NE(model.segmentation.curves[0].length, from.segmentation.curves[0].length);
}

TEST(TransferLabels, SubdividedFacetsKeepTheLabelOfTheirParent) {
  const TriMesh body = tests::irregular_body();
  const SegmentedModel from = segment_mesh(body, body_sketch(body), {}).model;
  const TransferredSegmentation to = transfer_labels(subdivided(body), from, {}, {});
  EXPECT_FALSE(to.copied);
  EXPECT_LT(to.moved_area, 1e-9);
  EXPECT_LT(to.largest_distance, 1e-9);
  const std::vector<int>& labels = to.segmented.model.segmentation.labels;
  for (int f = 0; f < body.facet_count(); ++f) {
    for (int i = 0; i < 4; ++i) ASSERT_EQ(labels[4 * f + i], from.segmentation.labels[f]);
  }
  EXPECT_TRUE(compare_segmentations(from, to.segmented.model).empty());
  EXPECT_LT(to.segmented.model.anchors[0].snap_distance, 1e-9);
}

TEST(TransferLabels, OtherTrianglesGetNearlyTheSameParts) {
  const TriMesh body = tests::irregular_body();
  const SegmentedModel from = segment_mesh(body, body_sketch(body), {}).model;
  const TriMesh other = resampled(body);
  const TransferredSegmentation to = transfer_labels(other, from, {}, {});
  EXPECT_GT(to.moved_area, 0);
  EXPECT_LT(to.moved_area, 0.03);
  EXPECT_TRUE(compare_segmentations(from, to.segmented.model).empty());
  // Nearly as straight as where they come from, or, as these triangles are, as when strokes are drawn on
  // them.
  const auto& moved = to.segmented.model.segmentation.curves;
  const auto& given = from.segmentation.curves;
  const auto drawn = segment_mesh(other, body_sketch(other), {}).model.segmentation.curves;
  ASSERT_EQ(moved.size(), given.size());
  ASSERT_EQ(moved.size(), drawn.size());
  for (std::size_t c = 0; c < moved.size(); ++c) {
    EXPECT_LT(moved[c].length, 1.15 * std::max(given[c].length, drawn[c].length));
  }
}

TEST(TransferLabels, SharesAreThoseOfTheArea) {
  // One large facet over a fine grid whose left third is another part.
  const TriMesh fine = tests::grid(30);
  std::vector<int> labels(fine.facet_count());
  for (int f = 0; f < fine.facet_count(); ++f) {
    double x = 0;
    for (const int v : fine.facet(f)) x += fine.point(v).x() / 3;
    labels[f] = x < -1 / 3.0 ? 0 : 1;
  }
  const TriMesh coarse({{-1, -1, 0.1}, {1, -1, 0.1}, {1, 1, 0.1}, {-1, 1, 0.1}}, {{0, 1, 2}, {0, 2, 3}});
  const LabelShares found = closest_labels(coarse, fine, labels, 2);
  EXPECT_NEAR(found.shares(0, 0), 1 / 9.0, 0.06);  // the triangle below the diagonal: (1/3)^2
  EXPECT_NEAR(found.shares(1, 0), 5 / 9.0, 0.06);
  EXPECT_NEAR(found.shares.row(1).sum(), 1, 1e-12);
  EXPECT_NEAR(found.mean_distance, 0.1, 1e-12);
  EXPECT_NEAR(found.largest_distance, 0.1, 1e-12);
}

TEST(TransferLabels, MeshesApartAreRefusedUnlessTheirBoxesAreAligned) {
  const TriMesh body = tests::irregular_body();
  const SegmentedModel from = segment_mesh(body, body_sketch(body), {}).model;
  const TriMesh same = subdivided(body);
  Points points = same.points();
  for (Vec3& p : points) p = 1000 * p + Vec3(1, 2, 3);
  const TriMesh elsewhere = same.with_points(points);
  try {
    transfer_labels(elsewhere, from, {}, {});
    FAIL() << "labels passed between meshes that lie apart";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("--align-boxes"), std::string::npos) << error.what();
  }
  TransferOptions options;
  options.align_boxes = true;
  const TransferredSegmentation aligned = transfer_labels(elsewhere, from, {}, options);
  EXPECT_EQ(aligned.segmented.model.segmentation.labels,
            transfer_labels(same, from, {}, {}).segmented.model.segmentation.labels);
}

TEST(TransferLabels, ASketchAddsAndReplacesLandmarks) {
  const TriMesh body = tests::irregular_body();
  const SegmentedModel from = segment_mesh(body, body_sketch(body), {}).model;
  Sketch more;
  more.parts = {{"top", {}}, {"bottom", {}}};
  more.markers = {{"tip", 7}, {"tail", 9}};
  more.anchors = {{"back", {"top", "bottom"}, vertex_near(body, {0, 1, 0.1})}};
  const SegmentedModel to = transfer_labels(body, from, more, {}).segmented.model;
  ASSERT_EQ(to.markers.size(), 2U);
  EXPECT_EQ(position(to.mesh, to.markers[0].point), body.point(7));
  EXPECT_EQ(to.markers[1].name, "tail");
  ASSERT_EQ(to.anchors.size(), 2U);
  EXPECT_EQ(to.anchors[0].vertex, from.anchors[0].vertex);
  EXPECT_EQ(to.anchors[1].name, "back");
  more.parts.push_back({"wing", {}});
  EXPECT_THROW(transfer_labels(body, from, more, {}), InputError);
}

TEST(TransferLabels, OneSketchServesAllPosesAndResolutionsOfACat) {
  const char* const reference = std::getenv("PARTWISE_REFERENCE_DATA");
  if (reference == nullptr) GTEST_SKIP() << "PARTWISE_REFERENCE_DATA is not set";
  const std::filesystem::path folder(reference);
  auto mesh = [&](const std::string& name) {
    return io::read_mesh(io::read_document((folder / "meshes" / (name + ".ply")).string()));
  };
  const TriMesh cat = mesh("cat-reference");
  const SegmentedModel from =
      segment_mesh(cat, io::read_sketch((folder / "sketches/cat.sketch.json").string()), {}).model;
  for (int pose = 1; pose <= 9; ++pose) {
    const TransferredSegmentation to = transfer_labels(mesh("cat-0" + std::to_string(pose)), from, {}, {});
    EXPECT_TRUE(to.copied);
    EXPECT_TRUE(compare_segmentations(from, to.segmented.model).empty()) << pose;
  }
  for (const bool slides : {false, true}) {
    const TriMesh other = slides ? resampled(cat) : subdivided(cat);
    const TransferredSegmentation to = transfer_labels(other, from, {}, {});
    EXPECT_LT(to.moved_area, 0.03) << slides;
    for (const std::string& difference : compare_segmentations(from, to.segmented.model)) {
      ADD_FAILURE() << slides << ": " << difference;
    }
    RecordProperty(slides ? "moved_resampled" : "moved_subdivided", std::to_string(to.moved_area));
    const LabelShares shares = closest_labels(other, cat, from.segmentation.labels, 7);
    EXPECT_LT(share_of_difference(other, most_probable_parts(shares.shares),
                                  to.segmented.model.segmentation.labels),
              0.02);
  }
}

}  // namespace
}  // namespace partwise
