#include "segmentation/seeds.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "builders.h"
#include "error.h"
#include "segmentation/sketches.h"

namespace partwise {
namespace {

std::string complaint(const TriMesh& mesh, const std::vector<std::string>& names,
                      const std::vector<SeedStroke>& strokes) {
  try {
    collect_seeds(mesh, names, strokes);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Seeds, FacetsTouchedByTwoPartsStayUnseeded) {
  const TriMesh mesh = tests::grid(4);  // vertex 5 i + j
  const Seeds seeds = collect_seeds(mesh, {"a", "b"}, {{0, 0, {6}}, {1, 0, {7}}});
  EXPECT_EQ(seeds.vertex_part[6], 0);
  EXPECT_EQ(seeds.vertex_part[7], 1);
  EXPECT_EQ(seeds.vertex_part[8], kUnseeded);
  // Each of the two vertices has six facets; the two at the edge between them are contested.
  EXPECT_EQ(std::count(seeds.facet_part.begin(), seeds.facet_part.end(), 0), 4);
  EXPECT_EQ(std::count(seeds.facet_part.begin(), seeds.facet_part.end(), 1), 4);
}

TEST(Seeds, AStrokeThatOthersCoverIsRefused) {
  const TriMesh mesh = tests::grid(4);
  EXPECT_EQ(
      complaint(mesh, {"a", "b"}, {{0, 0, {4}}, {0, 1, {12}}, {1, 0, {6, 7, 8, 11, 12, 13, 16, 17, 18}}}),
      "part 'a', stroke 1: strokes of other parts touch every facet it touches (near vertex 12); move it "
      "away from them");
}

TEST(Seeds, EveryPartNeedsAStroke) {
  EXPECT_EQ(complaint(tests::grid(2), {"a", "b"}, {{0, 0, {1}}}),
            "part 'b' has no stroke; draw at least one");
}

TEST(Seeds, ComponentsWithoutStrokeAndPartsOnTwoComponentsAreRefused) {
  const TriMesh mesh = tests::two_spheres(2);
  const int n = mesh.vertex_count() / 2;
  EXPECT_NE(complaint(mesh, {"a", "b"}, {{0, 0, {0}}, {1, 0, {n - 1}}}).find("has no stroke"),
            std::string::npos);
  EXPECT_NE(complaint(mesh, {"a", "b"}, {{0, 0, {0, n}}, {1, 0, {n - 1}}})
                .find("strokes on two unconnected components"),
            std::string::npos);
  EXPECT_EQ(complaint(mesh, {"a", "b"}, {{0, 0, {0}}, {1, 0, {n}}}), "");
}

}  // namespace
}  // namespace partwise
