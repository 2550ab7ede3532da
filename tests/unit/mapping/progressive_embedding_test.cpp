#include "mapping/progressive_embedding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "builders.h"
#include "error.h"
#include "mapping/lifted_embedding.h"
#include "mapping/relax_on_hull.h"
#include "mapping/ring_mesh.h"

namespace partwise {
namespace {

struct Coverage {
  int folds = 0;
  double degree = 0;  // solid angles over 4 pi
};

Coverage coverage(const Points& points, const Facets& facets) {
  Coverage result;
  for (const auto& [i, j, k] : facets) {
    const Vec3 a = points[i].normalized(), b = points[j].normalized(), c = points[k].normalized();
    const double volume = a.dot((b - a).cross(c - a));
    if (!(volume > 0)) ++result.folds;
    result.degree += 2 * std::atan2(volume, 1 + a.dot(b) + b.dot(c) + c.dot(a)) / (4 * std::numbers::pi);
  }
  return result;
}

Points embedded(const TriMesh& mesh) {
  return embed_progressively(mesh, std::vector<double>(mesh.vertex_count(), 1.0));
}

TEST(RingMesh, RestoresWhatItCollapsed) {
  const TriMesh mesh = tests::bumpy_sphere(3, 0.4);
  RingMesh rings(mesh);
  const RingMesh original = rings;
  std::vector<std::pair<int, RingMesh::Ring>> record;
  for (int u = 0; u < mesh.vertex_count(); ++u) {
    for (const int v : RingMesh::Ring(rings.ring(u))) {
      if (!rings.can_collapse(u, v)) continue;
      record.emplace_back(u, rings.collapse(u, v));
      break;
    }
  }
  EXPECT_EQ(rings.present_count(), mesh.vertex_count() - static_cast<int>(record.size()));
  EXPECT_LT(rings.present_count(), mesh.vertex_count() / 4);
  for (; !record.empty(); record.pop_back()) rings.restore(record.back().first, record.back().second);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    RingMesh::Ring expected = original.ring(v), found = rings.ring(v);
    std::rotate(expected.begin(), std::min_element(expected.begin(), expected.end()), expected.end());
    std::rotate(found.begin(), std::min_element(found.begin(), found.end()), found.end());
    EXPECT_EQ(found, expected) << "around vertex " << v;
  }
}

TEST(LiftedEmbedding, IsOneToOneFromEveryVertex) {
  for (const TriMesh& mesh : {tests::tetrahedron(), tests::cube(3), tests::bumpy_sphere(8, 1.5)}) {
    for (int v = 0; v < mesh.vertex_count(); v += 1 + mesh.vertex_count() / 20) {
      const Points directions = embed_by_lifting(mesh, v);
      const Coverage found = coverage(directions, mesh.facets());
      EXPECT_EQ(found.folds, 0);
      EXPECT_NEAR(found.degree, 1, 1e-9);
      for (const Vec3& direction : directions) EXPECT_NEAR(direction.norm(), 1, 1e-12);
    }
  }
}

TEST(ProgressiveEmbedding, IsOneToOne) {
  for (const TriMesh& mesh : {tests::tetrahedron(), tests::cube(6), tests::bumpy_sphere(16, 1.5),
                              tests::capsule(12, 16, 60), tests::capsule(40, 8, 200)}) {
    const Coverage found = coverage(embedded(mesh), mesh.facets());
    EXPECT_EQ(found.folds, 0) << mesh.facet_count() << " facets";
    EXPECT_NEAR(found.degree, 1, 1e-9);
  }
}

TEST(ProgressiveEmbedding, DoesNotChangeWithScale) {
  const TriMesh mesh = tests::bumpy_sphere(8, 0.5);
  Points larger;
  for (const Vec3& p : mesh.points()) larger.push_back(1024 * p);
  const Points before = embedded(mesh), after = embedded(mesh.with_points(larger));
  for (int v = 0; v < mesh.vertex_count(); ++v) EXPECT_LT((before[v] - after[v]).norm(), 1e-9);
}

TEST(ProgressiveEmbedding, RefusesSurfacesThatAreNoSphere) {
  EXPECT_THROW(embedded(tests::torus(2, 1, 12, 8)), InputError);
  EXPECT_THROW(embedded(tests::hemisphere(4)), InputError);
}

ConvexHull box_hull() {
  const TriMesh box = tests::cube(1);
  std::vector<int> vertices(box.vertex_count());
  return {box.points(), box.facets(), vertices};
}

TEST(RelaxOnHull, MakesTheMapOfACubeOntoItselfAnIsometry) {
  const TriMesh mesh = tests::cube(6);
  const StarHull hull(box_hull(), Vec3::Zero());
  // Directions that are bent, but still one-to-one.
  Points start;
  for (const Vec3& p : mesh.points()) start.push_back(p + Vec3(0.3 * p.y() * p.y(), 0.2 * p.z(), 0));
  ASSERT_EQ(coverage(start, mesh.facets()).folds, 0);
  const std::vector<double> weights(mesh.vertex_count(), 1.0);
  const HullRelaxation relaxed = relax_on_hull(mesh, weights, hull, start, {}, {});
  EXPECT_EQ(coverage(relaxed.images, mesh.facets()).folds, 0);
  EXPECT_LT(relaxed.distortion, 1.05);
  for (const Vec3& p : relaxed.images) EXPECT_NEAR(p.cwiseAbs().maxCoeff(), 1, 1e-12);
}

TEST(RelaxOnHull, LeavesFixedVerticesWhereTheyAre) {
  const TriMesh mesh = tests::cube(4);
  const StarHull hull(box_hull(), Vec3::Zero());
  std::vector<bool> fixed(mesh.vertex_count(), false);
  fixed[5] = fixed[17] = true;
  const std::vector<double> weights(mesh.vertex_count(), 1.0);
  Points start;
  for (const Vec3& p : mesh.points()) start.push_back(p + Vec3(0, 0.1 * p.x() * p.z(), 0));
  const HullRelaxation relaxed = relax_on_hull(mesh, weights, hull, start, fixed, {});
  for (const int v : {5, 17}) {
    EXPECT_LT((relaxed.images[v] - hull.project(start[v], 0).position).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace partwise
