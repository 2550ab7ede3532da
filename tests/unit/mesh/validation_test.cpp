#include "mesh/validation.h"

#include <gtest/gtest.h>

#include <limits>

#include "builders.h"
#include "error.h"

namespace partwise {
namespace {

std::string only_defect(const Points& points, const Facets& facets) {
  const std::vector<std::string> defects = find_defects(points, facets);
  return defects.size() == 1 ? defects.front()
                             : "expected one defect, found " + std::to_string(defects.size());
}

class Defects : public testing::Test {
 protected:
  Points points = tests::tetrahedron().points();
  Facets facets = tests::tetrahedron().facets();
};

TEST_F(Defects, NoneInValidMeshes) {
  for (const TriMesh& mesh :
       {tests::tetrahedron(), tests::cube(4), tests::sphere(8), tests::torus(2, 1, 12, 8),
        tests::hemisphere(8), tests::grid(3), tests::capsule(4, 12, 20)}) {
    EXPECT_TRUE(find_defects(mesh.points(), mesh.facets()).empty());
  }
}

TEST_F(Defects, EmptyMesh) {
  EXPECT_NE(only_defect({}, {}).find("no facets"), std::string::npos);
}

TEST_F(Defects, NotFinitePosition) {
  points[2].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(only_defect(points, facets).find("vertex 2 has a coordinate that is not finite"),
            std::string::npos);
}

TEST_F(Defects, IndexOutOfRange) {
  facets[1][2] = 4;
  EXPECT_NE(only_defect(points, facets).find("facet 1 names vertex 4 but the mesh has 4"), std::string::npos);
  facets[1][2] = -1;
  EXPECT_NE(only_defect(points, facets).find("facet 1 names vertex -1"), std::string::npos);
}

TEST_F(Defects, RepeatedVertex) {
  facets[3] = {1, 3, 1};
  EXPECT_NE(only_defect(points, facets).find("facet 3 names vertex 1 twice"), std::string::npos);
}

TEST_F(Defects, DuplicateFacet) {
  facets.push_back({2, 0, 1});
  const std::vector<std::string> defects = find_defects(points, facets);
  ASSERT_FALSE(defects.empty());
  EXPECT_NE(defects.front().find("facets 0 and 4 have the same three vertices"), std::string::npos);
}

TEST_F(Defects, EdgeWithThreeFacets) {
  points.emplace_back(0, 0, 9);
  facets.push_back({0, 1, 4});
  EXPECT_NE(only_defect(points, facets).find("edge (0, 1) has 3 facets"), std::string::npos);
}

TEST_F(Defects, OppositeOrientation) {
  std::swap(facets[2][0], facets[2][1]);
  EXPECT_NE(only_defect(points, facets).find("have opposite orientations along their edge"),
            std::string::npos);
}

TEST_F(Defects, PinchedVertex) {
  points.insert(points.end(), {{2, 0, 0}, {2, 1, 0}, {2, 0, 1}});
  for (const Facet& f : {Facet{0, 4, 5}, Facet{0, 6, 4}, Facet{0, 5, 6}, Facet{4, 6, 5}}) facets.push_back(f);
  EXPECT_NE(only_defect(points, facets).find("the facets at vertex 0 form 2 fans"), std::string::npos);
}

TEST_F(Defects, UnusedVertex) {
  points.emplace_back(0, 0, 0);
  EXPECT_NE(only_defect(points, facets).find("vertex 4 has no facet"), std::string::npos);
  EXPECT_THROW(TriMesh(points, facets), InputError);
}

}  // namespace
}  // namespace partwise
