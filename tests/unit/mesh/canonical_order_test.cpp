#include "mesh/canonical_order.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "builders.h"

namespace partwise {
namespace {

std::vector<int> shuffled(int count, std::mt19937& random) {
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  for (int i = count - 1; i > 0; --i) std::swap(order[i], order[random() % static_cast<unsigned>(i + 1)]);
  return order;
}

/// The mesh moved by `motion`, vertex v called numbers[v], facets in another order, corners turned.
TriMesh renumbered(const TriMesh& mesh, const std::vector<int>& numbers, const Eigen::Affine3d& motion,
                   std::mt19937& random) {
  Points points(mesh.vertex_count());
  for (int v = 0; v < mesh.vertex_count(); ++v) points[numbers[v]] = motion * mesh.point(v);
  Facets facets;
  for (const int f : shuffled(mesh.facet_count(), random)) {
    const auto& [a, b, c] = mesh.facet(f);
    Facet facet{numbers[a], numbers[b], numbers[c]};
    std::rotate(facet.begin(), facet.begin() + random() % 3, facet.end());
    facets.push_back(facet);
  }
  return {points, facets};
}

void expect_same_order_however_numbered(const TriMesh& mesh) {
  std::mt19937 random(7);
  const CanonicalOrder expected = canonical_order(mesh);
  for (int run = 0; run < 5; ++run) {
    const std::vector<int> numbers = shuffled(mesh.vertex_count(), random);
    const Eigen::Affine3d motion = Eigen::Translation3d(3, -20, 7) *
                                   Eigen::AngleAxisd(run, Vec3(1, run, -2).normalized()) *
                                   Eigen::Scaling(std::pow(10.0, run - 2));
    const CanonicalOrder found = canonical_order(renumbered(mesh, numbers, motion, random));
    for (int i = 0; i < mesh.vertex_count(); ++i) {
      ASSERT_EQ(found.vertices[i], numbers[expected.vertices[i]]) << "place " << i;
    }
    EXPECT_EQ(found.mesh.facets(), expected.mesh.facets());
  }
}

TEST(CanonicalOrder, IsThatOfTheShape) {
  const TriMesh mesh = tests::bumpy_sphere(6, 0.3);
  Points points = mesh.points();
  for (Vec3& p : points) p *= 1 + 0.03 * std::sin(5 * p.x() + 1) + 0.04 * std::sin(3 * p.y() + 2);
  expect_same_order_however_numbered(mesh.with_points(points));
}

TEST(CanonicalOrder, TellsAMirrorSymmetricShapesSidesApart) {
  Points points = tests::sphere(6).points();
  for (Vec3& p : points)
    p = Vec3(p.x() * (1 + 0.3 * p.y()), 2 * p.y(), p.z() * (1.5 + 0.2 * p.y() * p.y() * p.z()));
  const TriMesh mesh = tests::sphere(6).with_points(points);
  expect_same_order_however_numbered(mesh);
}

TEST(CanonicalOrder, KeepsTheMeshAndNumbersEveryVertexOnce) {
  const TriMesh mesh = tests::bumpy_sphere(3, 0.2);
  const CanonicalOrder order = canonical_order(mesh);
  std::vector<int> sorted = order.vertices;
  std::sort(sorted.begin(), sorted.end());
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_EQ(sorted[v], v);
    EXPECT_EQ(order.mesh.point(v), mesh.point(order.vertices[v]));
  }
  EXPECT_EQ(order.mesh.facet_count(), mesh.facet_count());
}

}  // namespace
}  // namespace partwise
