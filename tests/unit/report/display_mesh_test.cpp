#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "builders.h"
#include "geometry/normals.h"
#include "mesh/segmentation.h"
#include "report/display_meshes.h"

namespace partwise::report {
namespace {

// Facets above the plane z = 0 are part 1.
std::vector<int> halves(const TriMesh& mesh) {
  std::vector<int> labels;
  for (const Facet& f : mesh.facets()) {
    labels.push_back(mesh.point(f[0]).z() + mesh.point(f[1]).z() + mesh.point(f[2]).z() > 0 ? 1 : 0);
  }
  return labels;
}

TriMesh shown_mesh(const TriMesh& mesh, const DisplayMesh& display) {
  Points points;
  for (const int v : display.vertices) points.push_back(mesh.point(v));
  return {points, display.facets};  // throws when it is no manifold
}

TEST(DisplayMesh, LeavesSmallMeshesAlone) {
  const TriMesh mesh = tests::sphere(8);
  const DisplayMesh display = display_mesh(mesh, halves(mesh), mesh.facet_count());
  EXPECT_EQ(display.facets, mesh.facets());
  EXPECT_FALSE(display.is_decimated(mesh));
  for (int v = 0; v < mesh.vertex_count(); ++v) EXPECT_EQ(display.vertices[v], v);
}

TEST(DisplayMesh, KeepsShapeOrientationAndTopology) {
  const TriMesh mesh = tests::bumpy_sphere(24, 0.3);
  const DisplayMesh display = display_mesh(mesh, std::vector<int>(mesh.facet_count(), 0), 1000);
  const TriMesh shown = shown_mesh(mesh, display);
  EXPECT_TRUE(display.is_decimated(mesh));
  EXPECT_LE(shown.facet_count(), 1000);
  EXPECT_EQ(shown.euler_characteristic(), 2);
  const Points normals = facet_normals(shown.points(), shown.facets());
  for (int f = 0; f < shown.facet_count(); ++f) {
    EXPECT_GT(normals[f].dot(shown.point(shown.facet(f)[0])), 0) << "facet " << f << " is turned over";
  }
}

TEST(DisplayMesh, KeepsBoundariesBetweenParts) {
  const TriMesh mesh = tests::sphere(24);
  const std::vector<int> labels = halves(mesh);
  const DisplayMesh display = display_mesh(mesh, labels, 600);
  const std::set<int> kept(display.vertices.begin(), display.vertices.end());
  for (const BoundaryCurve& curve : trace_boundaries(mesh, {"below", "above"}, labels).curves) {
    for (const int v : curve.vertices) EXPECT_TRUE(kept.contains(v)) << "vertex " << v;
  }
  // A shown facet has the part of its origin: all its corners are corners of that part.
  std::vector<std::set<int>> vertices_of(2);
  for (int f = 0; f < mesh.facet_count(); ++f) {
    vertices_of[labels[f]].insert(mesh.facet(f).begin(), mesh.facet(f).end());
  }
  for (std::size_t f = 0; f < display.facets.size(); ++f) {
    for (const int v : display.facets[f]) {
      EXPECT_TRUE(vertices_of[labels[display.origin[f]]].contains(display.vertices[v]));
    }
  }
}

TEST(DisplayMesh, KeepsTheBoundaryOfOpenMeshes) {
  const TriMesh mesh = tests::grid(30);
  const DisplayMesh display = display_mesh(mesh, std::vector<int>(mesh.facet_count(), 0), 400);
  double area = 0;
  const TriMesh shown = shown_mesh(mesh, display);
  for (const double a : facet_areas(shown.points(), shown.facets())) area += a;
  EXPECT_NEAR(area, 4, 1e-9);
  EXPECT_LT(shown.facet_count(), mesh.facet_count() / 2);
}

TEST(DisplayMeshes, DecimateEachModelOnce) {
  const TriMesh mesh = tests::bumpy_sphere(12, 0.3), other = tests::sphere(12);
  const std::vector<int> labels = halves(mesh);
  DisplayMeshes displays(500);
  const DisplayMesh& first = displays.of(mesh, labels);
  EXPECT_EQ(first.facets, display_mesh(mesh, labels, 500).facets);
  EXPECT_EQ(displays.of(other, labels).facets, display_mesh(other, labels, 500).facets);
  EXPECT_EQ(displays.of(mesh, std::vector<int>(labels.size(), 0)).facets,
            display_mesh(mesh, std::vector<int>(labels.size(), 0), 500).facets);
  EXPECT_EQ(displays.size(), 3U);
  EXPECT_EQ(&displays.of(tests::bumpy_sphere(12, 0.3), labels), &first);
  EXPECT_EQ(displays.size(), 3U);
}

}  // namespace
}  // namespace partwise::report
