#include "mapping/build_hulls.h"

#include <gtest/gtest.h>

#include "builders.h"
#include "error.h"

namespace partwise {
namespace {

SegmentedModel split_at(const TriMesh& mesh, double z) {
  std::vector<int> labels;
  for (const Facet& f : mesh.facets()) {
    labels.push_back(mesh.point(f[0]).z() + mesh.point(f[1]).z() + mesh.point(f[2]).z() < 3 * z ? 1 : 0);
  }
  return {mesh, trace_boundaries(mesh, {"top", "bottom"}, labels), {}, {}, {}};
}

TEST(BuildHulls, EveryPartHasItsHullAndHullVerticesArePartVertices) {
  const HulledModel hulled = build_hulls(split_at(tests::capsule(2, 16, 20), 0));
  ASSERT_EQ(hulled.parts.size(), 2U);
  ASSERT_EQ(hulled.hulls.size(), 2U);
  for (int k = 0; k < 2; ++k) {
    const ConvexHull& hull = hulled.hulls[k];
    ASSERT_EQ(hull.part_vertex.size(), hull.points.size());
    for (std::size_t i = 0; i < hull.points.size(); ++i) {
      EXPECT_FALSE(hulled.parts[k].is_cap_vertex(hull.part_vertex[i]));
      EXPECT_EQ(hull.points[i], hulled.parts[k].mesh.point(hull.part_vertex[i]));
    }
  }
}

TEST(BuildHulls, NamesAFlatPart) {
  // The top side of a cube is a part of its own.
  try {
    build_hulls(split_at(tests::cube(3), 0.99));
    FAIL() << "a flat part has no hull";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("part \"top\""), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("one plane"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace partwise
