#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "io/sketch.h"
#include "io/stage_documents.h"
#include "segmentation/compatibility.h"
#include "segmentation/segment_mesh.h"

namespace partwise {
namespace {

namespace fs = std::filesystem;

/// The .off files of CGAL's demo: header, counts, points, triangles.
TriMesh read_off(const fs::path& path) {
  std::ifstream in(path);
  std::string magic;
  int vertex_count = 0, facet_count = 0, edge_count = 0;
  in >> magic >> std::ws;
  while (in.peek() == '#') in.ignore(1000, '\n');
  in >> vertex_count >> facet_count >> edge_count;
  Points points(vertex_count);
  for (Vec3& p : points) in >> p[0] >> p[1] >> p[2];
  Facets facets(facet_count);
  for (auto& [a, b, c] : facets) {
    int corners = 0;
    in >> corners >> a >> b >> c;
  }
  return TriMesh(std::move(points), std::move(facets));
}

/// Folder of an environment variable; skips the test when it is unset.
#define REQUIRE_FOLDER(variable, name)            \
  const char* const variable = std::getenv(name); \
  if (variable == nullptr) GTEST_SKIP() << name << " is not set"

SegmentedMesh segmented(const fs::path& mesh, const fs::path& sketch) {
  const TriMesh surface =
      mesh.extension() == ".off" ? read_off(mesh) : io::read_mesh(io::read_document(mesh.string()));
  return segment_mesh(surface, io::read_sketch(sketch.string()), {});
}

void expect_compatible(const SegmentedModel& a, const SegmentedModel& b, const std::string& which) {
  for (const std::string& difference : compare_segmentations(a, b))
    ADD_FAILURE() << which << ": " << difference;
  for (const std::string& sentence : misplaced_markers(a, b)) ADD_FAILURE() << which << ": " << sentence;
}

/// Sketched anchors lie near the boundaries found.
void expect_near_anchors(const SegmentedModel& model, const std::string& which) {
  for (const Anchor& anchor : model.anchors) {
    EXPECT_LT(anchor.snap_distance, 0.05 * model.mesh.diagonal()) << which << ": " << anchor.name;
  }
}

TEST(RealMeshes, AnimalsAreCutIntoCorrespondingParts) {
  REQUIRE_FOLDER(reference, "PARTWISE_REFERENCE_DATA");
  const fs::path meshes = fs::path(reference) / "meshes", sketches = fs::path(reference) / "sketches";
  const SegmentedMesh cat = segmented(meshes / "cat-reference.ply", sketches / "cat.sketch.json");
  const SegmentedMesh lion = segmented(meshes / "lion-reference.ply", sketches / "lion.sketch.json");
  EXPECT_EQ(cat.model.segmentation.curves.size(), 6U);
  expect_near_anchors(cat.model, "cat");
  expect_near_anchors(lion.model, "lion");
  expect_compatible(cat.model, lion.model, "cat and lion");
  REQUIRE_FOLDER(demo, "PARTWISE_DEMO_MESHES");
  for (const std::string name : {"camel", "cow", "triceratops", "diplodocus"}) {
    const SegmentedMesh other =
        segmented(fs::path(demo) / (name + ".off"), sketches / (name + ".sketch.json"));
    expect_near_anchors(other.model, name);
    expect_compatible(cat.model, other.model, "cat and " + name);
  }
}

TEST(RealMeshes, HumansAreCutIntoCorrespondingParts) {
  REQUIRE_FOLDER(reference, "PARTWISE_REFERENCE_DATA");
  const fs::path meshes = fs::path(reference) / "meshes", sketches = fs::path(reference) / "sketches";
  const SegmentedMesh man = segmented(meshes / "man.ply", sketches / "man.sketch.json");
  const SegmentedMesh baby = segmented(meshes / "baby.ply", sketches / "baby.sketch.json");
  EXPECT_EQ(man.model.segmentation.curves.size(), 9U);
  expect_near_anchors(man.model, "man");
  expect_near_anchors(baby.model, "baby");
  expect_compatible(man.model, baby.model, "man and baby");
}

}  // namespace
}  // namespace partwise
