// Writes a mesh of known shape: sample_mesh SHAPE OUT.ply, with the shapes of mesh_called below,
// or prints the part of every facet: sample_mesh labels SEGMENTED.ply
#include <iostream>
#include <string>

#include "builders.h"
#include "error.h"
#include "io/stage_documents.h"

using namespace partwise;

namespace {

TriMesh mesh_called(const std::string& name) {
  if (name == "capsule") return tests::capsule(4, 24, 45);
  if (name == "fine-capsule") return tests::capsule(4, 31, 70);
  if (name == "torus") return tests::torus(3, 1, 24, 12);
  if (name == "fat-torus") return tests::torus(3, 1.4, 31, 15);
  if (name == "two-spheres") return tests::two_spheres(4);
  if (name == "cube") return tests::cube(30);
  if (name == "bumpy-sphere") return tests::bumpy_sphere(37, 0.4);
  if (name == "jack") return tests::bumpy_sphere(24, 2.5);
  if (name == "hemisphere") return tests::hemisphere(16);
  if (name == "fine-hemisphere") return tests::hemisphere(22);
  throw UsageError("unknown shape " + name);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const std::string what = argv[1], path = argv[2];
  try {
    if (what == "labels") {
      const SegmentedModel model = io::read_segmented_model(io::read_document(path));
      for (const int label : model.segmentation.labels) std::cout << label << '\n';
    } else {
      io::write_document(path, io::to_document(mesh_called(what)), true);
    }
    return 0;
  } catch (const Error& error) {
    std::cerr << error.what() << '\n';
    return error.exit_code();
  }
}
