#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "builders.h"
#include "segmentation/crease_field.h"
#include "segmentation/growth.h"
#include "segmentation/label_repair.h"
#include "segmentation/label_topology.h"
#include "segmentation/random_walker.h"
#include "segmentation/sketches.h"

namespace partwise {
namespace {

TriMesh turned_inside_out(const TriMesh& mesh) {
  Facets facets = mesh.facets();
  for (Facet& f : facets) std::swap(f[0], f[1]);
  return TriMesh(mesh.points(), std::move(facets));
}

Seeds seeds_at_ends(const TriMesh& mesh) {
  return collect_seeds(
      mesh, {"south", "north"},
      {{0, 0, {tests::vertex_near(mesh, {0, 0, -9})}}, {1, 0, {tests::vertex_near(mesh, {0, 0, 9})}}});
}

double height(const TriMesh& mesh, int facet) {
  const auto& [a, b, c] = mesh.facet(facet);
  return (mesh.point(a).z() + mesh.point(b).z() + mesh.point(c).z()) / 3;
}

TEST(CreaseField, IsZeroOnAConvexSurfaceAndTheCurvatureOnAConcaveOne) {
  const TriMesh ball = tests::sphere(24);
  for (const double c : edge_concavity(ball)) EXPECT_EQ(c, 0);
  // Rings count every edge twice and every facet thrice: 2/3 of the curvature 1 / r, times l = sqrt(12) r.
  for (const double c : edge_concavity(turned_inside_out(ball))) {
    EXPECT_NEAR(c, 2.0 / 3 * std::sqrt(12.0), 0.4);
  }
}

TEST(CreaseField, DoesNotChangeWithScale) {
  const TriMesh mesh = tests::irregular_body();
  Points large;
  for (const Vec3& p : mesh.points()) large.push_back(1000 * p);
  const std::vector<double> before = edge_concavity(mesh), after = edge_concavity(mesh.with_points(large));
  for (std::size_t e = 0; e < before.size(); ++e) EXPECT_NEAR(before[e], after[e], 1e-9 * (1 + before[e]));
}

TEST(RandomWalker, ProbabilitiesSumToOneAndFallAwayFromTheirSeeds) {
  const TriMesh mesh = tests::capsule(4, 24, 48);
  const PartProbabilities p = walk_randomly(mesh, seeds_at_ends(mesh), 2, edge_concavity(mesh));
  for (int f = 0; f < mesh.facet_count(); ++f) {
    EXPECT_NEAR(p.row(f).sum(), 1, 1e-9);
    EXPECT_GE(p.row(f).minCoeff(), -1e-12);
    if (std::abs(height(mesh, f)) > 0.2) {
      EXPECT_EQ(p(f, 1) > p(f, 0), height(mesh, f) > 0);
    }
  }
}

TEST(Growth, FollowsTheCheapestStepFirst) {
  // The waist at z = 0 is concave: regions grown from the ends of the capsule meet there.
  const TriMesh mesh = tests::capsule(4, 24, 48);
  const std::vector<int> labels = grow_regions(mesh, seeds_at_ends(mesh));
  int wrong = 0;
  for (int f = 0; f < mesh.facet_count(); ++f) {
    if (std::abs(height(mesh, f)) > 1) wrong += labels[f] != (height(mesh, f) > 0 ? 1 : 0);
  }
  EXPECT_EQ(wrong, 0);
}

TEST(Growth, AFacetTakesTheLargestPartOfItsVertices) {
  const TriMesh mesh = tests::tetrahedron();
  const Seeds seeds{{0, 0, 1, 2}, {kUnseeded, kUnseeded, kUnseeded, kUnseeded}};
  EXPECT_EQ(grow_regions(mesh, seeds), (std::vector<int>{1, 2, 2, 2}));
}

class RepairedNoise : public testing::TestWithParam<unsigned> {};

/// Whatever the labelling, the repaired one has connected, unpinched parts; valid ones stay as they are.
TEST_P(RepairedNoise, IsValid) {
  std::mt19937 random(GetParam());
  const TriMesh meshes[] = {tests::sphere(14), tests::hemisphere(14), tests::torus(3, 1, 40, 20)};
  const TriMesh& mesh = meshes[GetParam() % 3];
  std::vector<int> labels;
  const double noise = 0.05 + 0.3 * std::uniform_real_distribution<double>()(random);
  for (int f = 0; f < mesh.facet_count(); ++f) {
    const auto& [a, b, c] = mesh.facet(f);
    const Vec3 p = mesh.point(a) + mesh.point(b) + mesh.point(c);
    int label = p.x() > 0 ? (p.y() > 0 ? 0 : 1) : 2;
    if (std::uniform_real_distribution<double>()(random) < noise) {
      label = std::uniform_int_distribution<int>(0, 2)(random);
    }
    labels.push_back(label);
  }
  const Seeds none{std::vector<int>(mesh.vertex_count(), kUnseeded),
                   std::vector<int>(mesh.facet_count(), kUnseeded)};
  const std::vector<double> costs = boundary_costs(mesh, edge_concavity(mesh));
  const std::vector<std::string> names{"a", "b", "c"};
  const RepairedLabels repaired = repair_labels(mesh, names, none, labels, costs);
  EXPECT_NO_THROW(trace_boundaries(mesh, names, repaired.labels));
  EXPECT_GT(repaired.merged_islands, 0);
  const RepairedLabels again = repair_labels(mesh, names, none, repaired.labels, costs);
  EXPECT_EQ(again.labels, repaired.labels);
  EXPECT_EQ(again.changed_facets, 0);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RepairedNoise, testing::Range(0U, 30U));

TEST(LabelRepair, SeedsDecideWhichComponentStays) {
  const TriMesh mesh = tests::sphere(12);
  std::vector<int> labels;
  for (int f = 0; f < mesh.facet_count(); ++f) labels.push_back(std::abs(height(mesh, f)) > 0.6 ? 1 : 0);
  // Both caps are called 1; the one with a seed stays.
  const Seeds seeds = collect_seeds(
      mesh, {"belt", "cap"},
      {{0, 0, {tests::vertex_near(mesh, {1, 0, 0})}}, {1, 0, {tests::vertex_near(mesh, {0, 0, -1})}}});
  const std::vector<double> costs = boundary_costs(mesh, edge_concavity(mesh));
  const RepairedLabels repaired = repair_labels(mesh, {"belt", "cap"}, seeds, labels, costs);
  EXPECT_EQ(repaired.merged_islands, 1);
  for (int f = 0; f < mesh.facet_count(); ++f) EXPECT_EQ(repaired.labels[f], height(mesh, f) < -0.6 ? 1 : 0);
}

TEST(LabelTopology, CountsExtraFans) {
  const TriMesh mesh = tests::grid(2);  // vertex 4 in the middle has six facets
  std::vector<int> labels(8, 0);
  EXPECT_EQ(extra_fans(mesh, labels, 4), 0);
  const std::vector<int> around = facets_around(mesh, 4);
  ASSERT_EQ(around.size(), 6U);
  labels[around[0]] = 1;
  EXPECT_EQ(extra_fans(mesh, labels, 4), 0);
  labels[around[3]] = 1;
  EXPECT_EQ(extra_fans(mesh, labels, 4), 2);  // both parts have two fans
  labels[around[3]] = 2;
  EXPECT_EQ(extra_fans(mesh, labels, 4), 1);  // part 0 has two
}

}  // namespace
}  // namespace partwise
