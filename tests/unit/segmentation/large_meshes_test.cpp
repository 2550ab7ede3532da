#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <variant>

#include "builders.h"
#include "geometry/normals.h"
#include "segmentation/crease_field.h"
#include "segmentation/segmenter.h"
#include "segmentation/sketches.h"

namespace partwise {
namespace {

using tests::part_at;

/// A capsule bent to and fro and thinned in two places, so that no edge loop is a boundary by itself.
TriMesh bent_capsule(int around, int along) {
  const TriMesh straight = tests::capsule(6, around, along);
  Points points;
  for (const Vec3& p : straight.points()) {
    const double waist = 1 - 0.35 * std::exp(-4 * std::pow(std::abs(p.z()) - 1.3, 2));
    points.push_back(
        {waist * p.x() + 0.4 * std::sin(p.z()), waist * p.y() + 0.2 * std::cos(1.7 * p.z() + 0.3), p.z()});
  }
  return straight.with_points(std::move(points));
}

Sketch three_parts(const TriMesh& mesh) {
  Sketch sketch;
  sketch.parts = {part_at(mesh, "south", {{0, 0, -4}, {0.5, 0, -3}}),
                  part_at(mesh, "middle", {{1, 0.2, 0}, {-1, 0.2, 0}}),
                  part_at(mesh, "north", {{0, 0, 4}, {0.5, 0, 3}})};
  return sketch;
}

/// Share of the area whose facets have different labels.
double share_that_differs(const TriMesh& mesh, const std::vector<int>& a, const std::vector<int>& b) {
  const std::vector<double> areas = facet_areas(mesh.points(), mesh.facets());
  double sum = 0, different = 0;
  for (std::size_t f = 0; f < areas.size(); ++f) {
    sum += areas[f];
    different += a[f] != b[f] ? areas[f] : 0;
  }
  return different / sum;
}

TEST(LargeMeshes, CutCoarseToFineAreCutAsOnOneLevel) {
  const TriMesh mesh = bent_capsule(150, 200);
  ASSERT_GT(mesh.facet_count(), SegmentationOptions().largest_exact);
  const Sketch sketch = three_parts(mesh);
  const Segmentation coarse_to_fine = segment_mesh(mesh, sketch, {}).model.segmentation;
  SegmentationOptions on_one_level;
  on_one_level.largest_exact = mesh.facet_count();
  const Segmentation exact = segment_mesh(mesh, sketch, on_one_level).model.segmentation;
  EXPECT_LT(share_that_differs(mesh, coarse_to_fine.labels, exact.labels), 0.01);
  ASSERT_EQ(coarse_to_fine.curves.size(), 2U);
  for (int i = 0; i < 2; ++i) {
    EXPECT_TRUE(coarse_to_fine.curves[i].closed);
    EXPECT_LT(coarse_to_fine.curves[i].length, 1.05 * exact.curves[i].length);
  }
}

TEST(LargeMeshes, LabelsDoNotChangeWithThreadsScaleAndEarlierStrokes) {
  const TriMesh mesh = bent_capsule(150, 200);
  Sketch sketch = three_parts(mesh);
  Segmenter segmenter(mesh);
  const std::vector<int> labels = segmenter.segment(sketch).model.segmentation.labels;

  Sketch more = sketch;
  more.parts[1].strokes.push_back(part_at(mesh, "middle", {{0.5, 0.2, 2.2}}).strokes[0]);
  EXPECT_NE(segmenter.segment(more).model.segmentation.labels, labels);
  EXPECT_EQ(segmenter.segment(sketch).model.segmentation.labels, labels);

  Points points;
  for (const Vec3& p : mesh.points()) points.push_back(1024 * p);
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(segment_mesh(mesh.with_points(points), sketch, {}).model.segmentation.labels, labels);
}

/// The bent capsule with bumps, so that no two of its facets are alike.
TriMesh bumpy_capsule(int around, int along) {
  const TriMesh bent = bent_capsule(around, along);
  Points points;
  for (const Vec3& p : bent.points()) {
    points.push_back(p + 0.03 * Vec3(std::sin(5 * p.y() + 2 * p.z()), std::sin(4 * p.z() + 3 * p.x()),
                                     std::sin(6 * p.x() + p.y())));
  }
  return bent.with_points(std::move(points));
}

Sketch with_vertices(Sketch sketch, const std::vector<int>& new_vertex) {
  for (SketchedPart& part : sketch.parts) {
    for (Stroke& stroke : part.strokes) {
      for (int& v : std::get<VertexStroke>(stroke).vertices) v = new_vertex[v];
    }
  }
  return sketch;
}

TEST(LargeMeshes, LabelsDoNotChangeWithNumbering) {
  const TriMesh mesh = bumpy_capsule(150, 200);
  ASSERT_GT(mesh.facet_count(), SegmentationOptions().largest_exact);
  const Sketch sketch = three_parts(mesh);
  const std::vector<int> labels = segment_mesh(mesh, sketch, {}).model.segmentation.labels;
  const tests::Renumbered other = tests::renumbered(mesh, 5);
  const std::vector<int> theirs =
      segment_mesh(other.mesh, with_vertices(sketch, other.new_vertex), {}).model.segmentation.labels;
  std::vector<int> same(labels.size());
  for (std::size_t f = 0; f < labels.size(); ++f) same[f] = theirs[other.new_facet[f]];
  EXPECT_EQ(share_that_differs(mesh, same, labels), 0);
}

TEST(LargeMeshes, LabelsDoNotChangeWithScaleAndHardlyWithRotation) {
  const TriMesh mesh = bumpy_capsule(150, 200);
  const Sketch sketch = three_parts(mesh);
  const std::vector<int> labels = segment_mesh(mesh, sketch, {}).model.segmentation.labels;
  auto labels_of = [&](const Eigen::Matrix3d& transform, const Vec3& shift) {
    Points points;
    for (const Vec3& p : mesh.points()) points.push_back(transform * p + shift);
    return segment_mesh(mesh.with_points(std::move(points)), sketch, {}).model.segmentation.labels;
  };
  const Eigen::Matrix3d quarter_turn = Eigen::AngleAxisd(EIGEN_PI / 2, Vec3::UnitX()).toRotationMatrix();
  EXPECT_EQ(share_that_differs(mesh, labels_of(1000 * quarter_turn, Vec3(50, -3, 7)), labels), 0);
  // The diagonal of the bounding box, which the crease field is relative to, changes with other turns.
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  EXPECT_LT(share_that_differs(mesh, labels_of(turn, Vec3::Zero()), labels), 0.005);
}

TEST(LargeMeshes, NearlyEqualCreasesOnOneLevelAndOnSeveral) {
  const TriMesh mesh = bent_capsule(180, 240);
  const std::vector<double> exact = edge_concavity(mesh);
  const std::vector<double> quick = edge_concavity(mesh, FacetHierarchy(mesh, 20'000));
  double sum = 0, difference = 0;
  for (std::size_t e = 0; e < exact.size(); ++e) {
    sum += exact[e];
    difference += std::abs(exact[e] - quick[e]);
  }
  EXPECT_GT(sum, 0);
  EXPECT_LT(difference, 0.1 * sum);
}

TEST(FacetHierarchy, LevelsPartitionTheFacetsIntoConnectedGroups) {
  const TriMesh mesh = tests::sphere(30);
  const FacetHierarchy hierarchy(mesh, 100);
  const auto& levels = hierarchy.levels();
  EXPECT_LE(levels.back().node_count(), 100);
  for (std::size_t k = 0; k + 1 < levels.size(); ++k) {
    const auto& level = levels[k];
    for (int i = 0; i < level.node_count(); ++i) {
      for (int link = level.first[i]; link < level.first[i + 1]; ++link) {
        const bool is_inside = level.parent[i] == level.parent[level.neighbour[link]];
        ASSERT_EQ(level.link_above[link] < 0, is_inside);
        if (!is_inside) {
          ASSERT_EQ(levels[k + 1].neighbour[level.link_above[link]], level.parent[level.neighbour[link]]);
        }
      }
    }
  }
  // What lies between facets is summed, whatever the level.
  const std::vector<double> concavity = edge_concavity(mesh), costs = boundary_costs(mesh, concavity);
  const auto graphs = graphs_of_levels(hierarchy, facet_graph(mesh, concavity, costs));
  ASSERT_EQ(graphs.size(), levels.size());
  double facets = 0, groups = 0;
  for (const double size : graphs.front().size) facets += size;
  for (const double size : graphs.back().size) groups += size;
  EXPECT_NEAR(groups, facets, 1e-9 * facets);
}

}  // namespace
}  // namespace partwise
