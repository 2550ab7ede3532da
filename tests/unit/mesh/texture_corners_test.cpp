#include "mesh/texture_corners.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "builders.h"

namespace partwise {
namespace {

TEST(SplitAtSeams, DoublesVerticesOfTheSeamOnly) {
  const TriMesh mesh = tests::capsule(4, 12, 6);
  const TextureCorners texture = tests::cylindrical_texture(mesh);
  const SeamVertices split = split_at_seams(mesh.vertex_count(), mesh.facets(), texture);
  for (int f = 0; f < mesh.facet_count(); ++f) {
    for (int i = 0; i < 3; ++i) {
      const int vertex = split.facets[f][i];
      EXPECT_EQ(split.origins[vertex], mesh.facet(f)[i]);
      EXPECT_LE((split.places[vertex] - texture.place(f, i)).norm(), kTextureJump);
    }
  }
  for (int v = 0; v < mesh.vertex_count(); ++v) EXPECT_EQ(split.origins[v], v);
  ASSERT_GT(split.origins.size(), mesh.points().size());
  for (std::size_t v = mesh.points().size(); v < split.origins.size(); ++v) {
    const Vec3& p = mesh.point(split.origins[v]);
    EXPECT_TRUE(std::abs(p.y()) < 1e-9 && p.x() < 1e-9)
        << "vertex " << split.origins[v] << " is off the seam";
  }
}

TEST(SplitAtSeams, WithoutSeamsNothingIsDoubled) {
  const TriMesh mesh = tests::grid(4);
  TextureCorners texture;
  for (const auto& [a, b, c] : mesh.facets()) {
    texture.places.push_back({mesh.point(a).x(), mesh.point(a).y(), mesh.point(b).x(), mesh.point(b).y(),
                              mesh.point(c).x() + 1e-9, mesh.point(c).y()});  // rounding is no seam
  }
  const SeamVertices split = split_at_seams(mesh.vertex_count(), mesh.facets(), texture);
  EXPECT_EQ(split.facets, mesh.facets());
  EXPECT_EQ(split.origins.size(), mesh.points().size());
}

}  // namespace
}  // namespace partwise
