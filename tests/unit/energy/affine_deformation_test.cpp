#include "energy/affine_deformation.h"

#include <gtest/gtest.h>

#include "builders.h"
#include "solve/least_squares.h"

namespace partwise {
namespace {

Vec3 affine(const Vec3& p) {
  Eigen::Matrix3d map;
  map << 1.2, 0.3, 0, -0.1, 0.7, 0.2, 0.4, 0, 1.5;
  return map * p + Vec3(3, 1, 2);
}

/// Deforms the mesh so that some vertices come to given places.
Points deformed(const TriMesh& mesh, const std::vector<VertexTarget>& wanted) {
  std::vector<VertexTarget> fixed;
  for (const VertexTarget& w : wanted) fixed.push_back({4 * w.vertex, w.target});
  LeastSquares system(4 * mesh.vertex_count(), fixed);
  system.add(1, affine_deformation_term(mesh.points(), mesh.facets()));
  system.add(1e-9, affine_rest_term(mesh.points(), mesh.facets()));
  const Points solution = system.minimise();
  Points places;
  for (int v = 0; v < mesh.vertex_count(); ++v) places.push_back(solution[4 * v]);
  return places;
}

TEST(AffineDeformation, FollowsAnAffineMapOfFourVertices) {
  const TriMesh mesh = tests::sphere(4);
  std::vector<VertexTarget> wanted;
  for (const int v : {0, 1, 2, 4}) wanted.push_back({v, affine(mesh.point(v))});
  const Points places = deformed(mesh, wanted);
  for (int v = 0; v < mesh.vertex_count(); ++v) EXPECT_LT((places[v] - affine(mesh.point(v))).norm(), 1e-4);
}

TEST(AffineDeformation, CostsWhatItsFormulaSays) {
  // One edge's share for a single facet with unit legs: everything at rest but the first place.
  const Points rest{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Facets facets{{0, 1, 2}};
  const double h = (2 + std::sqrt(2.0)) / 3;
  Points unknowns;
  for (const Vec3& p : rest) {
    unknowns.push_back(p);
    for (int k = 0; k < 3; ++k) unknowns.push_back(h * Vec3::Unit(k));
  }
  const EnergyTerm term = affine_deformation_term(rest, facets);
  EXPECT_NEAR(energy(term, unknowns), 0, 1e-15);
  EXPECT_NEAR(energy(affine_rest_term(rest, facets), unknowns), 0, 1e-15);
  unknowns[0] += Vec3(0, 0, 0.5);  // two edges, seen from both ends
  EXPECT_NEAR(energy(term, unknowns), 4 * 0.25, 1e-14);
  unknowns[0] -= Vec3(0, 0, 0.5);
  unknowns[3] += Vec3(0, 0, 0.5);  // its map across the facet: the neighbours' maps differ, no edge does
  EXPECT_NEAR(energy(term, unknowns), 2 * 0.25, 1e-14);
}

TEST(AffineDeformation, LeavesAFlatMeshFlat) {
  const TriMesh mesh = tests::grid(4);
  std::vector<VertexTarget> wanted;
  for (const int v : {0, 4, 20, 24}) wanted.push_back({v, 2 * mesh.point(v)});
  const Points places = deformed(mesh, wanted);
  for (int v = 0; v < mesh.vertex_count(); ++v) EXPECT_LT((places[v] - 2 * mesh.point(v)).norm(), 1e-4);
}

}  // namespace
}  // namespace partwise
