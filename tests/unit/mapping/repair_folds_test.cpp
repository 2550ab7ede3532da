#include "mapping/repair_folds.h"

#include <gtest/gtest.h>

#include "builders.h"
#include "measure/hull_folds.h"

namespace partwise {
namespace {

int folds(const TriMesh& mesh, const Points& directions) {
  return hull_folds(directions, mesh.facets(), Vec3::Zero()).count();
}

Points repaired(const TriMesh& mesh, const Points& directions) {
  return repair_folds(mesh.facets(), mean_value_weights(mesh.points(), mesh.facets()), directions);
}

TEST(RepairFolds, LeavesAMapWithoutFoldsAlone) {
  const TriMesh mesh = tests::sphere(6);
  EXPECT_EQ(repaired(mesh, mesh.points()), mesh.points());
}

TEST(RepairFolds, UndoesWhatTwoMisplacedVerticesFold) {
  const TriMesh mesh = tests::sphere(10);
  Points directions = mesh.points();
  const Vec3 first = directions[40];
  for (const int v : {40, 200}) directions[v] = (directions[v] + Vec3(0.5, 0.2, -0.3)).normalized();
  ASSERT_GT(folds(mesh, directions), 0);
  const Points result = repaired(mesh, directions);
  EXPECT_EQ(folds(mesh, result), 0);
  EXPECT_LT((result[40] - first).norm(), 0.1);
  int moved = 0;
  for (int v = 0; v < mesh.vertex_count(); ++v) moved += result[v] != directions[v];
  EXPECT_LT(moved, mesh.vertex_count() / 4);
}

TEST(RepairFolds, UndoesAPatchTurnedOver) {
  const TriMesh mesh = tests::sphere(10);
  Points directions = mesh.points();
  for (Vec3& p : directions) {
    if (p.z() > 0.9) p.x() = -p.x();  // a mirrored cap at the pole
  }
  ASSERT_GT(folds(mesh, directions), 20);
  const Points result = repaired(mesh, directions);
  EXPECT_EQ(folds(mesh, result), 0);
  EXPECT_NEAR(hull_folds(result, mesh.facets(), Vec3::Zero()).degree, 1, 1e-9);
}

TEST(RepairFolds, NeverAddsFolds) {
  // A surface turned inside out cannot be repaired by moving to means.
  const TriMesh mesh = tests::bumpy_sphere(5, 0.3);
  Points directions = mesh.points();
  for (Vec3& p : directions) p = -p;
  EXPECT_LE(folds(mesh, repaired(mesh, directions)), folds(mesh, directions));
}

}  // namespace
}  // namespace partwise
