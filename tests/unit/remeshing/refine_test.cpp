#include "remeshing/refine.h"

#include <gtest/gtest.h>

#include "builders.h"
#include "convex_pairs.h"
#include "error.h"
#include "measure/certificate.h"
#include "measure/self_intersections.h"
#include "measure/surface_distance.h"
#include "remeshing/reconstruct.h"
#include "remeshing/split_source.h"

namespace partwise {
namespace {

CompatibleMesh coarse_on_bumps() {
  return reconstruct(tests::projected_pair(tests::whole(tests::sphere(6)),
                                           tests::whole(tests::bumpy_sphere(20, 0.4))))
      .mesh;
}

double two_sided(const CompatibleMesh& mesh) {
  return surface_distance(mesh.source.with_points(mesh.points), mesh.target).max / mesh.target.diagonal();
}

double two_sided_rms(const CompatibleMesh& mesh) {
  return surface_distance(mesh.source.with_points(mesh.points), mesh.target).rms;
}

TEST(Refine, BringsBothSurfacesTogetherByAddedVertices) {
  const CompatibleMesh mesh = coarse_on_bumps();
  ASSERT_GT(two_sided(mesh), 0.012);
  const Refined result = refine(mesh, {.error = 0.004, .limit = 4});
  EXPECT_LE(two_sided(result.mesh), 0.004);
  EXPECT_EQ(result.figures.gaps_after, 0);
  EXPECT_GT(result.figures.gaps_before, 0);
  EXPECT_EQ(result.mesh.source.vertex_count(), mesh.source.vertex_count() + result.figures.added_vertices);
  EXPECT_LT(result.figures.added_vertices, 2.2 * mesh.source.vertex_count());
  EXPECT_EQ(original_source(result.mesh).facets(), mesh.source.facets());
  EXPECT_TRUE(certify(result.mesh).one_to_one());
  EXPECT_EQ(MeshOnSurface(result.mesh).flipped_count(), 0);
  EXPECT_TRUE(self_intersections(result.mesh.points, result.mesh.source.facets()).empty());
}

TEST(Refine, StopsAtTheLimit) {
  const CompatibleMesh mesh = coarse_on_bumps();
  const Refined result = refine(mesh, {.error = 0.001, .limit = 0.1});
  EXPECT_EQ(result.figures.added_vertices, static_cast<int>(0.1 * mesh.source.vertex_count()));
  EXPECT_GT(result.figures.gaps_after, 0);
  EXPECT_LT(result.figures.gaps_after, result.figures.gaps_before);
  // So few vertices need not lower the largest distance, but the surfaces come closer.
  EXPECT_LE(two_sided(result.mesh), two_sided(mesh));
  EXPECT_LT(two_sided_rms(result.mesh), 0.95 * two_sided_rms(mesh));
  EXPECT_TRUE(certify(result.mesh).one_to_one());
}

TEST(Refine, AddsNothingWhereNothingIsMissing) {
  const CompatibleMesh mesh = coarse_on_bumps();
  EXPECT_EQ(refine(mesh, {.error = 0}).figures.added_vertices, 0);
  EXPECT_EQ(refine(mesh, {.error = 0.5}).figures.added_vertices, 0);
  EXPECT_TRUE(refine(mesh, {.error = 0.5}).mesh.refinement.is_empty());
  EXPECT_THROW(refine(mesh, {.error = -1}), InputError);
}

}  // namespace
}  // namespace partwise
