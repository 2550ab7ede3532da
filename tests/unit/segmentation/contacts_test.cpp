#include "segmentation/contacts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "builders.h"
#include "mesh/segmentation.h"
#include "segmentation/crease_field.h"

namespace partwise {
namespace {

/// A sphere with two caps, a around +x and b around -x, in the rest c. They meet on x = 0 where |y| < reach
/// and z > 0.
class TwoCaps : public testing::Test {
 protected:
  TriMesh mesh = tests::sphere(24);
  std::vector<double> costs = boundary_costs(mesh, edge_concavity(mesh));
  Seeds seeds{{}, std::vector<int>(mesh.facet_count(), kUnseeded)};

  Vec3 centroid(int f) const {
    const auto& [a, b, c] = mesh.facet(f);
    return (mesh.point(a) + mesh.point(b) + mesh.point(c)) / 3;
  }

  RepairedLabels touching(double reach) const {
    RepairedLabels repaired;
    for (int f = 0; f < mesh.facet_count(); ++f) {
      const Vec3 p = centroid(f);
      const bool in_cap = p.z() > 0 && std::abs(p.y()) < reach + 1.5 * std::abs(p.x()) && p.z() < 0.9 + reach;
      repaired.labels.push_back(!in_cap ? 2 : p.x() > 0 ? 0 : 1);
    }
    return repaired;
  }

  SeparatedLabels separated(double reach, double limit = 0.35) const {
    return separate_contacts(mesh, {"a", "b", "c"}, seeds, touching(reach), costs, limit);
  }

  std::size_t cross_points(const std::vector<int>& labels) const {
    return trace_boundaries(mesh, {"a", "b", "c"}, labels).cross_points.size();
  }
};

TEST_F(TwoCaps, ShortContactIsSeparatedAndSaid) {
  ASSERT_EQ(cross_points(touching(0.15).labels), 2U);
  const SeparatedLabels result = separated(0.15);
  EXPECT_EQ(cross_points(result.repaired.labels), 0U);
  ASSERT_EQ(result.sentences.size(), 1U);
  EXPECT_NE(result.sentences[0].find("'a' and 'b' touched"), std::string::npos);
  EXPECT_NE(result.sentences[0].find("strip of 'c'"), std::string::npos);
  const std::vector<int> before = touching(0.15).labels;
  for (int f = 0; f < mesh.facet_count(); ++f) {
    if (std::abs(centroid(f).x()) > 0.15) {
      EXPECT_EQ(result.repaired.labels[f], before[f]) << "far away";
    }
  }
}

TEST_F(TwoCaps, LongContactIsMeant) {
  const SeparatedLabels result = separated(0.15, 0.01);
  EXPECT_EQ(result.repaired.labels, touching(0.15).labels);
  EXPECT_TRUE(result.sentences.empty());
}

TEST_F(TwoCaps, StrokesAtTheContactMeanIt) {
  const std::vector<int> labels = touching(0.15).labels;
  for (int f = 0; f < mesh.facet_count(); ++f) {
    if (labels[f] < 2 && std::abs(centroid(f).x()) < 0.1) seeds.facet_part[f] = labels[f];
  }
  EXPECT_EQ(separated(0.15).repaired.labels, labels);
}

TEST_F(TwoCaps, WithoutContactNothingChanges) {
  RepairedLabels repaired = touching(0.15);
  for (int f = 0; f < mesh.facet_count(); ++f) {
    if (std::abs(centroid(f).x()) < 0.2) repaired.labels[f] = 2;
  }
  const SeparatedLabels result = separate_contacts(mesh, {"a", "b", "c"}, seeds, repaired, costs, 0.35);
  EXPECT_EQ(result.repaired.labels, repaired.labels);
}

}  // namespace
}  // namespace partwise
