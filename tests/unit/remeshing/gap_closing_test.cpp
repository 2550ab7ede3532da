#include "remeshing/gap_closing.h"

#include <gtest/gtest.h>

#include "builders.h"
#include "convex_pairs.h"
#include "measure/certificate.h"
#include "remeshing/coverage_gaps.h"
#include "remeshing/reconstruct.h"

namespace partwise {
namespace {

/// A coarse ball on a finer one with six arms, its vertices crowded about the upper arm, so that it stops
/// short of the lower one.
CompatibleMesh ball_on_jack() {
  const TriMesh ball = tests::sphere(6);
  Points crowded;
  for (const Vec3& p : ball.points()) crowded.push_back((p + 0.6 * Vec3::UnitZ()).normalized());
  return reconstruct(tests::projected_pair(tests::whole(ball.with_points(crowded)),
                                           tests::whole(tests::bumpy_sphere(12, 1))))
      .mesh;
}

double widest_gap(const CompatibleMesh& mesh) {
  const std::vector<CoverageGap> gaps = CoverageGaps(mesh.target).wider_than(0, mesh);
  return gaps.front().distance / mesh.target.diagonal();
}

CompatibleMesh closed(const CompatibleMesh& mesh, const std::vector<CriticalPair>& critical = {},
                      const GapClosingOptions& options = {}) {
  MeshOnSurface moving(mesh);
  close_gaps(moving, mesh, std::vector<double>(mesh.source.facet_count(), 1), critical, options);
  return with_images(mesh, moving.images());
}

TEST(GapClosing, HalvesTheWidestGapAndKeepsTheMapOneToOne) {
  const CompatibleMesh mesh = ball_on_jack();
  const CompatibleMesh result = closed(mesh);
  EXPECT_LT(widest_gap(result), 0.5 * widest_gap(mesh));
  EXPECT_TRUE(certify(result).one_to_one());
  EXPECT_EQ(MeshOnSurface(result).flipped_count(), MeshOnSurface(mesh).flipped_count());
}

TEST(GapClosing, LeavesPinnedVertices) {
  const CompatibleMesh mesh = ball_on_jack();
  MeshOnSurface moving(mesh);
  for (int v = 0; v < mesh.source.vertex_count(); ++v) moving.pin(v);
  moving.unpin(5);
  close_gaps(moving, mesh, std::vector<double>(mesh.source.facet_count(), 1), {}, {.rounds = 1});
  for (int v = 0; v < mesh.source.vertex_count(); ++v) {
    if (v == 5) continue;
    EXPECT_EQ(moving.points()[v], mesh.points[v]) << v;
  }
}

TEST(GapClosing, DoesNothingWhereGapsAreNarrowerOrInNoRounds) {
  const CompatibleMesh mesh = ball_on_jack();
  EXPECT_EQ(closed(mesh, {}, {.threshold = 1.1 * widest_gap(mesh)}).points, mesh.points);
  EXPECT_EQ(closed(mesh, {}, {.rounds = 0}).points, mesh.points);
}

TEST(GapClosing, DrawsVerticesToCriticalPoints) {
  const CompatibleMesh mesh = ball_on_jack();
  int tip = 0;
  for (int t = 1; t < mesh.target.vertex_count(); ++t) {
    if (mesh.target.point(t).x() > mesh.target.point(tip).x()) tip = t;
  }
  const Vec3& goal = mesh.target.point(tip);
  int nearest = 0;
  for (int v = 1; v < mesh.source.vertex_count(); ++v) {
    if ((mesh.points[v] - goal).norm() < (mesh.points[nearest] - goal).norm()) nearest = v;
  }
  const int other = mesh.source.half_edges().vv_range(OpenMesh::VertexHandle(nearest)).begin()->idx();
  const auto distance = [&](const CompatibleMesh& result) { return (result.points[other] - goal).norm(); };
  const GapClosingOptions once{.rounds = 1};
  EXPECT_LT(distance(closed(mesh, {{other, tip}}, once)), distance(closed(mesh, {}, once)));
}

}  // namespace
}  // namespace partwise
