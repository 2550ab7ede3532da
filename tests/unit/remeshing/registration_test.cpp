#include "remeshing/registration.h"

#include <gtest/gtest.h>

#include "builders.h"
#include "convex_pairs.h"
#include "measure/certificate.h"
#include "remeshing/reconstruct.h"

namespace partwise {
namespace {

/// A bumpy sphere on itself, but its bumps mapped beside themselves: the source is turned by a tenth.
CompatibleMesh turned_on_itself(const TriMesh& mesh) {
  const Eigen::AngleAxisd turn(0.1, Vec3(1, 2, 3).normalized());
  Points points;
  for (const Vec3& p : mesh.points()) points.push_back(turn * p);
  return reconstruct(tests::projected_pair(tests::whole(mesh.with_points(points)), tests::whole(mesh))).mesh;
}

/// Mean distance from where a vertex belongs: the one of the same number.
double mean_error(const MeshOnSurface& mesh) {
  double sum = 0;
  for (int v = 0; v < mesh.source().vertex_count(); ++v) {
    sum += (mesh.points()[v] - mesh.target().point(v)).norm();
  }
  return sum / mesh.source().vertex_count();
}

TEST(Registration, FindsTheFeaturesOfTheTarget) {
  const CompatibleMesh mesh = turned_on_itself(tests::bumpy_sphere(12, 0.3));
  const MeshOnSurface start(mesh);
  double error = 0;
  for (const VertexTarget& end : register_source(start)) {
    error += (end.target - mesh.target.point(end.vertex)).norm() / mesh.target.vertex_count();
    EXPECT_GE(end.weight, 0);
    EXPECT_LE(end.weight, 1);
  }
  EXPECT_LT(error, 0.5 * mean_error(start));
}

TEST(Registration, DrawsTheMapAndKeepsItOneToOne) {
  CompatibleMesh mesh = turned_on_itself(tests::bumpy_sphere(12, 0.3));
  MeshOnSurface moving(mesh);
  const double before = mean_error(moving);
  const std::vector<double> scales(mesh.source.facet_count(), 1);
  relax_towards_registration(moving, scales);
  EXPECT_LT(mean_error(moving), 0.5 * before);
  mesh.map = SurfaceMap(mesh.source, mesh.target, moving.images());
  mesh.points = moving.points();
  EXPECT_TRUE(certify(mesh).one_to_one());
}

TEST(Registration, LeavesPinnedVerticesAndDoesNothingInNoSteps) {
  const CompatibleMesh mesh = turned_on_itself(tests::bumpy_sphere(8, 0.3));
  MeshOnSurface moving(mesh);
  moving.pin(5);
  const Vec3 place = moving.points()[5];
  EXPECT_EQ(register_source(moving)[5].target, place);
  const Points before = moving.points();
  relax_towards_registration(moving, std::vector<double>(mesh.source.facet_count(), 1), {.steps = 0});
  EXPECT_EQ(moving.points(), before);
}

}  // namespace
}  // namespace partwise
