#include "segmentation/band_cut.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "builders.h"
#include "segmentation/crease_field.h"
#include "segmentation/minimum_cut.h"

namespace partwise {
namespace {

/// All assignments of a few variables tried out.
TEST(BinaryCut, FindsTheSmallestSum) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> cost(-9, 9);
  for (int trial = 0; trial < 50; ++trial) {
    constexpr int n = 6;
    std::array<int, n> single{};
    std::array<std::array<int, n>, n> pair{};
    BinaryCut cut(n);
    for (int i = 0; i < n; ++i) {
      cut.add_cost(i, single[i] = cost(random));
      for (int j = 0; j < n; ++j) {
        if (i != j) cut.add_pair_cost(i, j, pair[i][j] = std::max(0, cost(random)));
      }
    }
    auto sum = [&](auto&& is_set) {
      int total = 0;
      for (int i = 0; i < n; ++i) {
        total += is_set(i) ? single[i] : 0;
        for (int j = 0; j < n; ++j) total += !is_set(i) && is_set(j) ? pair[i][j] : 0;
      }
      return total;
    };
    int smallest = 0;
    for (int bits = 0; bits < 1 << n; ++bits) {
      smallest = std::min(smallest, sum([&](int i) { return (bits >> i & 1) != 0; }));
    }
    const std::vector<bool> found = cut.minimise();
    EXPECT_EQ(sum([&](int i) { return found[i]; }), smallest);
  }
}

class CapsuleInHalves : public testing::Test {
 protected:
  TriMesh mesh = tests::capsule(4, 24, 48);
  std::vector<double> costs = boundary_costs(mesh, edge_concavity(mesh));
  Seeds seeds{{}, std::vector<int>(mesh.facet_count(), kUnseeded)};

  double height(int f) const {
    return (mesh.point(mesh.facet(f)[0]) + mesh.point(mesh.facet(f)[1]) + mesh.point(mesh.facet(f)[2])).z() /
           3;
  }

  /// Two parts, in doubt where |z| is small, with a ragged line between them.
  PartProbabilities ragged() const {
    PartProbabilities probabilities(mesh.facet_count(), 2);
    for (int f = 0; f < mesh.facet_count(); ++f) {
      const double raised = height(f) + 0.25 * std::sin(37.0 * f);
      probabilities(f, 0) = 1 / (1 + std::exp(-2 * raised));
      probabilities(f, 1) = 1 - probabilities(f, 0);
    }
    return probabilities;
  }

  double boundary_length(const std::vector<int>& labels) const {
    double length = 0;
    const HalfEdges& half_edges = mesh.half_edges();
    for (const auto e : half_edges.edges()) {
      const auto h = half_edges.halfedge_handle(e, 0);
      const int a = half_edges.face_handle(h).idx(), b = half_edges.opposite_face_handle(h).idx();
      if (labels[a] != labels[b]) length += edge_length(mesh, e.idx());
    }
    return length;
  }
};

TEST_F(CapsuleInHalves, RaggedLineBecomesTheWaist) {
  const PartProbabilities probabilities = ragged();
  const double before = boundary_length(most_probable_parts(probabilities));
  const double after = boundary_length(cut_band(mesh, seeds, probabilities, costs, {}));
  EXPECT_GT(before, 8);
  EXPECT_NEAR(after, 2 * M_PI * 0.8, 0.1) << "around the waist, whose radius is 0.8";
}

TEST_F(CapsuleInHalves, SeedsAndCertainFacetsKeepTheirPart) {
  PartProbabilities probabilities = ragged();
  int island = 0;
  while (std::abs(height(island) - 0.5) > 0.05) ++island;
  probabilities.row(island) << 0, 1;
  EXPECT_EQ(cut_band(mesh, seeds, probabilities, costs, {})[island], 1) << "certain";
  probabilities.row(island) << 0.45, 0.55;
  EXPECT_EQ(cut_band(mesh, seeds, probabilities, costs, {})[island], 0) << "in doubt";
  seeds.facet_part[island] = 1;
  EXPECT_EQ(cut_band(mesh, seeds, probabilities, costs, {})[island], 1) << "seeded";
}

}  // namespace
}  // namespace partwise
