#include "remeshing/faults.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "builders.h"
#include "convex_pairs.h"
#include "mapped_pairs.h"
#include "measure/certificate.h"
#include "measure/self_intersections.h"
#include "remeshing/reconstruct.h"

namespace partwise {
namespace {

std::vector<int> all_facets(const MeshOnSurface& mesh) {
  std::vector<int> facets(mesh.source().facet_count());
  std::iota(facets.begin(), facets.end(), 0);
  return facets;
}

int faults(const MeshOnSurface& mesh) {
  return FaultCounter(mesh).of(all_facets(mesh));
}

/// A ball on one with six arms, its vertices moved about as far as the map stays one-to-one.
CompatibleMesh shaken_on_jack() {
  const CompatibleMesh mesh = reconstruct(tests::projected_pair(tests::whole(tests::sphere(10)),
                                                                tests::whole(tests::bumpy_sphere(16, 2))))
                                  .mesh;
  MeshOnSurface moving(mesh);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> step(-0.5, 0.5);
  for (int v = 0; v < mesh.source.vertex_count(); ++v) {
    const Vec3 goal = moving.points()[v] + Vec3(step(random), step(random), step(random));
    const SurfacePoint there = moving.walker().towards(moving.image(v), goal);
    if (moving.allows(v, there)) moving.place(v, there);
  }
  return with_images(mesh, moving.images());
}

TEST(Faults, AreFlippedFacetsAndPairsThatIntersect) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const MeshOnSurface mesh(tests::shaken(tests::sphere(8), 0.8, seed));
    const auto pairs = self_intersections(mesh.points(), mesh.source().facets());
    ASSERT_GT(pairs.size(), 0U);
    EXPECT_EQ(faults(mesh), mesh.flipped_count() + static_cast<int>(pairs.size()));
  }
}

TEST(Faults, AroundAVertexFollowItsMoves) {
  MeshOnSurface mesh(tests::shaken(tests::sphere(6), 0, 1));
  FaultCounter counter(mesh);
  const SurfacePoint home = mesh.image(7);
  EXPECT_EQ(counter.around(7), 0);
  mesh.place(7, mesh.walker().towards(home, -mesh.points()[7]));  // far over its neighbours
  EXPECT_GT(counter.around(7), 0);
  counter.moved(7);
  const int other = mesh.source().half_edges().vv_range(OpenMesh::VertexHandle(7)).begin()->idx();
  EXPECT_GT(counter.around(other), 0);
  mesh.place(7, home);
  counter.moved(7);
  EXPECT_EQ(counter.around(other), 0);
}

TEST(Faults, AreMendedWithoutFurtherFlips) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    MeshOnSurface mesh(tests::shaken(tests::sphere(8), 0.6, seed));
    const int before = faults(mesh), flipped = mesh.flipped_count();
    EXPECT_GT(mend_faults(mesh, 10), 0);
    EXPECT_LT(faults(mesh), before / 4);
    EXPECT_LE(mesh.flipped_count(), flipped);
  }
}

TEST(Faults, AreMendedWithinAOneToOneMap) {
  const CompatibleMesh start = shaken_on_jack();
  MeshOnSurface mesh(start);
  const int before = faults(mesh);
  ASSERT_GT(before, 0);
  mend_faults(mesh, 10);
  EXPECT_LT(faults(mesh), before / 2);
  EXPECT_TRUE(certify(with_images(start, mesh.images())).one_to_one());
}

TEST(Faults, MendingLeavesPinnedAndFaultlessVertices) {
  const CompatibleMesh start = tests::shaken(tests::sphere(8), 0.6, 4);
  MeshOnSurface pinned(start);
  for (int v = 0; v < start.source.vertex_count(); ++v) pinned.pin(v);
  EXPECT_EQ(mend_faults(pinned, 10), 0);
  EXPECT_EQ(pinned.points(), start.points);
  MeshOnSurface faultless(tests::shaken(tests::sphere(8), 0, 4));
  EXPECT_EQ(mend_faults(faultless, 10), 0);
}

}  // namespace
}  // namespace partwise
