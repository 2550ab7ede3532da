#include "mesh/part.h"

#include <gtest/gtest.h>

#include "builders.h"

namespace partwise {
namespace {

SegmentedModel halved_by_x(const TriMesh& mesh) {
  std::vector<int> labels;
  for (const Facet& f : mesh.facets()) {
    labels.push_back(mesh.point(f[0]).x() + mesh.point(f[1]).x() + mesh.point(f[2]).x() < 0 ? 1 : 0);
  }
  return {mesh, trace_boundaries(mesh, {"front", "back"}, labels), {}, {}, {}};
}

int euler_characteristic(const TriMesh& mesh) {
  return mesh.vertex_count() - static_cast<int>(mesh.half_edges().n_edges()) + mesh.facet_count();
}

TEST(Part, HalfSphereIsClosedByOneCap) {
  const SegmentedModel model = halved_by_x(tests::sphere(8));
  for (const int k : {0, 1}) {
    const Part part = extract_part(model, k);
    EXPECT_EQ(euler_characteristic(part.mesh), 2);
    ASSERT_EQ(part.loops.size(), 1U);
    EXPECT_EQ(part.loops.front().size(), 32U);
    EXPECT_EQ(part.mesh.facet_count(), 8 * 64 / 2 + 32);
    EXPECT_LT(part.mesh.point(part.cap_vertices.front()).norm(), 1e-12);
    for (int v = 0; v < part.mesh.vertex_count(); ++v) {
      if (part.is_cap_vertex(v)) continue;
      EXPECT_EQ(part.mesh.point(v), model.mesh.point(part.model_vertex[v]));
    }
  }
}

TEST(Part, HalfTorusIsClosedByTwoCaps) {
  const Part part = extract_part(halved_by_x(tests::torus(3, 1, 24, 10)), 0);
  EXPECT_EQ(part.loops.size(), 2U);
  EXPECT_EQ(euler_characteristic(part.mesh), 2);
}

TEST(Part, LoopHasThePartOnItsLeft) {
  const Part part = extract_part(halved_by_x(tests::sphere(8)), 0);
  const std::vector<int>& loop = part.loops.front();
  EXPECT_GT(part.mesh.point(loop[0]).cross(part.mesh.point(loop[1])).x(), 0);
}

}  // namespace
}  // namespace partwise
