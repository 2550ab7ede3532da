#include "segmentation/boundary_refinement.h"

#include <gtest/gtest.h>

#include <cmath>

#include "builders.h"
#include "mesh/curve_roughness.h"
#include "segmentation/crease_field.h"
#include "segmentation/segment_mesh.h"
#include "sketches.h"

namespace partwise {
namespace {

double total_length(const Segmentation& segmentation) {
  double sum = 0;
  for (const BoundaryCurve& curve : segmentation.curves) sum += curve.length;
  return sum;
}

class RefinedCapsule : public testing::Test {
 protected:
  TriMesh mesh = tests::capsule(4, 24, 48);
  std::vector<double> costs = boundary_costs(mesh, edge_concavity(mesh));
  Seeds seeds{{}, std::vector<int>(mesh.facet_count(), kUnseeded)};

  /// Halves with a boundary that wanders `height` up and down four times.
  std::vector<int> wavy(double height) const {
    std::vector<int> labels;
    for (const auto& [a, b, c] : mesh.facets()) {
      const Vec3 p = (mesh.point(a) + mesh.point(b) + mesh.point(c)) / 3;
      labels.push_back(p.z() > height * std::sin(4 * std::atan2(p.y(), p.x())) ? 0 : 1);
    }
    return labels;
  }

  Segmentation refined(const std::vector<int>& labels) const {
    return trace_boundaries(mesh, {"a", "b"}, refine_boundaries(mesh, seeds, 2, labels, costs, {}));
  }
};

TEST_F(RefinedCapsule, WavesBecomeTheWaist) {
  const std::vector<int> labels = wavy(0.3);
  EXPECT_GT(total_length(trace_boundaries(mesh, {"a", "b"}, labels)), 7);
  EXPECT_NEAR(total_length(refined(labels)), 2 * M_PI * 0.8, 0.1) << "around the waist, whose radius is 0.8";
}

TEST_F(RefinedCapsule, StraightBoundaryStays) {
  const std::vector<int> labels = wavy(0);
  EXPECT_EQ(refined(labels).labels, labels);
}

TEST_F(RefinedCapsule, SeedsStay) {
  const std::vector<int> labels = wavy(0.3);
  for (int f = 0; f < mesh.facet_count(); ++f) seeds.facet_part[f] = labels[f];
  EXPECT_EQ(refined(labels).labels, labels);
}

TEST_F(RefinedCapsule, MovesNoFurtherThanItsRounds) {
  const std::vector<int> labels = wavy(0.3);
  RefinementOptions options;
  options.rounds = 1;
  options.width = 1e-6;
  EXPECT_EQ(refine_boundaries(mesh, seeds, 2, labels, costs, options), labels);
}

TEST(RefinedGrowth, IsShorterThanRawGrowth) {
  const TriMesh mesh = tests::irregular_body();
  Sketch sketch;
  sketch.parts = {tests::part_at(mesh, "top", {{0, 0, 2}, {0.3, 0, 2}}),
                  tests::part_at(mesh, "bottom", {{0, 0, -2}, {0.3, 0, -2}})};
  SegmentationOptions options;
  options.method = SegmentationMethod::growth;
  const SegmentedMesh refined = segment_mesh(mesh, sketch, options);
  options.refine_growth = false;
  const SegmentedMesh raw = segment_mesh(mesh, sketch, options);
  EXPECT_LT(total_length(refined.model.segmentation), 0.97 * total_length(raw.model.segmentation));
  EXPECT_LT(mean_roughness(mesh, refined.model.segmentation), mean_roughness(mesh, raw.model.segmentation));
}

}  // namespace
}  // namespace partwise
