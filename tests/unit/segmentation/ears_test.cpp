#include "segmentation/ears.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "builders.h"
#include "mesh/segmentation.h"

namespace partwise {
namespace {

/// A sphere in two halves, ragged by a share of the facets along the seam.
class TwoHalves : public testing::Test {
 protected:
  TriMesh mesh = tests::sphere(12);
  Seeds seeds{{}, std::vector<int>(mesh.facet_count(), kUnseeded)};

  RepairedLabels halves() const {
    RepairedLabels repaired;
    for (const Facet& f : mesh.facets()) {
      const Vec3 p = (mesh.point(f[0]) + mesh.point(f[1]) + mesh.point(f[2])) / 3;
      repaired.labels.push_back(p.dot(Vec3(1, 0.35, 0.2)) > 0.1 ? 0 : 1);
    }
    return repaired;
  }

  Segmentation traced(const std::vector<int>& labels) const {
    return trace_boundaries(mesh, {"a", "b"}, labels);
  }

  std::vector<int> ears(const std::vector<int>& labels) const {
    std::vector<int> found;
    for (int f = 0; f < mesh.facet_count(); ++f) {
      int edges = 0;
      for (const auto g : mesh.half_edges().ff_range(OpenMesh::FaceHandle(f))) {
        if (labels[g.idx()] != labels[f]) ++edges;
      }
      if (edges == 2) found.push_back(f);
    }
    return found;
  }
};

TEST_F(TwoHalves, NoEarIsLeftAndTheBoundaryIsShorter) {
  const RepairedLabels before = halves();
  ASSERT_FALSE(ears(before.labels).empty());
  const RepairedLabels after = remove_ears(mesh, seeds, before);
  EXPECT_TRUE(ears(after.labels).empty());
  const Segmentation ragged = traced(before.labels), smooth = traced(after.labels);
  ASSERT_EQ(ragged.curves.size(), 1U);
  ASSERT_EQ(smooth.curves.size(), 1U);
  EXPECT_LT(smooth.curves[0].length, ragged.curves[0].length);
  int changed = 0;
  for (int f = 0; f < mesh.facet_count(); ++f) changed += before.labels[f] != after.labels[f] ? 1 : 0;
  EXPECT_GT(changed, 0);
  EXPECT_LE(changed, after.changed_facets);
}

TEST_F(TwoHalves, WhatAStrokeGaveStays) {
  const RepairedLabels before = halves();
  for (const int f : ears(before.labels)) seeds.facet_part[f] = before.labels[f];
  EXPECT_EQ(remove_ears(mesh, seeds, before).labels, before.labels);
}

TEST_F(TwoHalves, APartOfOneFacetStays) {
  RepairedLabels single;
  single.labels.assign(mesh.facet_count(), 1);
  single.labels[7] = 0;
  EXPECT_EQ(remove_ears(mesh, seeds, single).labels, single.labels);
}

}  // namespace
}  // namespace partwise
