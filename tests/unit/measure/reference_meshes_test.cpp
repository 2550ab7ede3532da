// Figures known of real meshes; skipped unless PARTWISE_REFERENCE_DATA says where they are.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "io/stage_documents.h"
#include "measure/self_intersections.h"

namespace partwise {
namespace {

std::size_t self_intersections_of(const std::string& name) {
  std::ifstream in(std::string(std::getenv("PARTWISE_REFERENCE_DATA")) + "/meshes/" + name, std::ios::binary);
  io::Document document;
  document.tables = io::read_ply(in);
  const TriMesh mesh = io::read_mesh(document);
  return self_intersections(mesh.points(), mesh.facets()).size();
}

TEST(ReferenceMeshes, SelfIntersectionsAreTheKnownOnes) {
  if (!std::getenv("PARTWISE_REFERENCE_DATA")) GTEST_SKIP() << "PARTWISE_REFERENCE_DATA is not set";
  EXPECT_EQ(self_intersections_of("cat-reference.ply"), 86U);
  EXPECT_EQ(self_intersections_of("lion-reference.ply"), 172U);
}

}  // namespace
}  // namespace partwise
