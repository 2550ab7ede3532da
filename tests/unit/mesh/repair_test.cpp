#include "mesh/repair.h"

#include <gtest/gtest.h>

#include <numeric>

#include "builders.h"
#include "error.h"
#include "mesh/tri_mesh.h"
#include "mesh/triangulate.h"

namespace partwise {
namespace {

TriangleSoup soup_of(const TriMesh& mesh) {
  return {mesh.points(), mesh.facets()};
}

TEST(Repair, LeavesGoodMeshesAlone) {
  for (const TriMesh& mesh :
       {tests::cube(3), tests::torus(2, 1, 12, 8), tests::hemisphere(4), tests::grid(3)}) {
    for (const auto repair :
         {drop_degenerate, drop_duplicates, drop_unused, keep_largest_component, orient}) {
      const Repaired result = repair(soup_of(mesh));
      EXPECT_EQ(result.count, 0);
      EXPECT_EQ(result.soup.points, mesh.points());
      EXPECT_EQ(result.soup.facets, mesh.facets());
    }
    EXPECT_EQ(merge_vertices(soup_of(mesh), 1e-6).count, 0);
  }
}

TEST(Repair, DropsDegenerateAndDuplicateFacets) {
  TriangleSoup soup = soup_of(tests::tetrahedron());
  const Facets good = soup.facets;
  soup.facets.insert(soup.facets.begin() + 1, {2, 2, 3});
  soup.facets.push_back({good[0][1], good[0][0], good[0][2]});
  const Repaired degenerate = drop_degenerate(soup);
  EXPECT_EQ(degenerate.count, 1);
  const Repaired duplicates = drop_duplicates(degenerate.soup);
  EXPECT_EQ(duplicates.count, 1);
  EXPECT_EQ(duplicates.soup.facets, good);
}

TEST(Repair, DropsUnusedVerticesInOrder) {
  TriangleSoup soup = soup_of(tests::tetrahedron());
  const Points good = soup.points;
  soup.points.insert(soup.points.begin() + 1, {9, 9, 9});
  for (Facet& facet : soup.facets) {
    for (int& vertex : facet) vertex += vertex >= 1 ? 1 : 0;
  }
  const Repaired result = drop_unused(soup);
  EXPECT_EQ(result.count, 1);
  EXPECT_EQ(result.soup.points, good);
  EXPECT_EQ(result.soup.facets, tests::tetrahedron().facets());
}

TEST(Repair, MergesTheSeamsOfATriangleSoup) {
  const TriMesh mesh = tests::sphere(6);
  for (const double scale : {1e-6, 1.0, 1e6}) {
    TriangleSoup soup;
    for (const Facet& facet : mesh.facets()) {
      const int first = static_cast<int>(soup.points.size());
      for (const int vertex : facet) {
        const double shake = 1e-9 * (static_cast<int>(soup.points.size()) % 5 - 2);
        soup.points.push_back(scale * (mesh.point(vertex) + Vec3(shake, -shake, shake)));
      }
      soup.facets.push_back({first, first + 1, first + 2});
    }
    const Repaired result = merge_vertices(soup, 1e-7);
    EXPECT_EQ(result.soup.points.size(), mesh.points().size());
    EXPECT_EQ(result.count, static_cast<long>(soup.points.size() - mesh.points().size()));
    EXPECT_NO_THROW(TriMesh(result.soup.points, result.soup.facets));
  }
  EXPECT_EQ(merge_vertices({{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}}, {}}, 0).count, 1)
      << "tolerance 0: equal points";
}

TEST(Repair, OrientsOutwardWhateverWasTurned) {
  for (const TriMesh& mesh : {tests::cube(3), tests::torus(2, 1, 12, 8)}) {
    TriangleSoup soup = soup_of(mesh);
    long turned = 0;
    for (std::size_t f = 0; f < soup.facets.size(); f += 1 + f % 3) {
      std::swap(soup.facets[f][1], soup.facets[f][2]);
      ++turned;
    }
    const Repaired result = orient(soup);
    EXPECT_EQ(result.count, turned);
    EXPECT_EQ(result.soup.facets, mesh.facets());
  }
}

TEST(Repair, OrientsOpenMeshesAsTheirFirstFacet) {
  TriangleSoup soup = soup_of(tests::grid(3));
  std::swap(soup.facets[5][1], soup.facets[5][2]);
  EXPECT_EQ(orient(soup).soup.facets, tests::grid(3).facets());
}

TEST(Repair, RefusesToOrientAMoebiusStrip) {
  TriangleSoup soup;
  const int n = 8;
  for (int i = 0; i < 2 * n; ++i) soup.points.emplace_back(i, i % 2, 0);
  for (int i = 0; i < n; ++i) {
    const int a = 2 * i, b = 2 * i + 1;
    const int c = i + 1 < n ? a + 2 : 1, d = i + 1 < n ? b + 2 : 0;
    soup.facets.push_back({a, c, b});
    soup.facets.push_back({b, c, d});
  }
  EXPECT_THROW(orient(soup), InputError);
}

TEST(Repair, KeepsTheLargestComponent) {
  TriangleSoup soup = soup_of(tests::tetrahedron());
  const TriMesh large = tests::cube(2);
  const int offset = static_cast<int>(soup.points.size());
  soup.points.insert(soup.points.end(), large.points().begin(), large.points().end());
  for (const Facet& f : large.facets()) soup.facets.push_back({f[0] + offset, f[1] + offset, f[2] + offset});
  const Repaired result = keep_largest_component(soup);
  EXPECT_EQ(result.count, 1);
  EXPECT_EQ(result.soup.points, large.points());
  EXPECT_EQ(result.soup.facets, large.facets());
  EXPECT_EQ(keep_largest_component({}).count, 0);
}

double area(const Points& points, const std::vector<Facet>& facets, bool absolute) {
  double sum = 0;
  for (const auto& [a, b, c] : facets) {
    const double z = (points[b] - points[a]).cross(points[c] - points[a]).z() / 2;
    sum += absolute ? std::abs(z) : z;
  }
  return sum;
}

TEST(Triangulate, CutsConcavePolygonsWithoutOverlap) {
  const std::vector<Points> outlines{
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
      {{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}},
      {{0, 0, 0}, {5, 0, 0}, {5, 5, 0}, {4, 5, 0}, {4, 1, 0}, {1, 1, 0}, {1, 5, 0}, {0, 5, 0}}};
  for (const Points& outline : outlines) {
    for (std::size_t shift = 0; shift < outline.size(); ++shift) {
      std::vector<int> corners(outline.size());
      for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = static_cast<int>((i + shift) % corners.size());
      const std::vector<Facet> facets = triangulate_polygon(outline, corners);
      EXPECT_EQ(facets.size(), outline.size() - 2);
      EXPECT_NEAR(area(outline, facets, false), area(outline, facets, true), 1e-12) << "an overlap";
      EXPECT_GT(area(outline, facets, false), 0);
    }
  }
}

TEST(Triangulate, ManagesWhatIsNoPolygon) {
  const Points line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {3, 0, 0}};
  EXPECT_EQ(triangulate_polygon(line, {0, 1, 2, 3, 4}).size(), 3U);
  EXPECT_EQ(triangulate_polygon(line, {0, 0, 0, 0}).size(), 2U);
}

}  // namespace
}  // namespace partwise
