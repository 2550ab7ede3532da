// Volumes of a model's parts, each closed by caps, in other shapes of the model: part_volumes SEGMENT.ply
// SHAPE.ply...
//
// One line per part: name, then one volume per shape over that of the whole segmented model.
#include <cstdio>
#include <exception>
#include <vector>

#include "io/stage_documents.h"
#include "mesh/part.h"

using namespace partwise;

namespace {

double volume(const TriMesh& mesh) {
  double six_times = 0;
  for (const auto& [a, b, c] : mesh.facets()) {
    six_times += mesh.point(a).dot(mesh.point(b).cross(mesh.point(c)));
  }
  return six_times / 6;
}

void print_volumes(const SegmentedModel& model, const std::vector<TriMesh>& shapes) {
  const double whole = volume(model.mesh);
  for (int k = 0; k < model.segmentation.part_count(); ++k) {
    std::printf("%-20s", model.segmentation.names[k].c_str());
    std::vector<bool> inside;
    for (const int label : model.segmentation.labels) inside.push_back(label == k);
    for (const TriMesh& shape : shapes) {
      std::printf(" %.5f",
                  volume(extract_piece(model.mesh.with_points(shape.points()), inside).mesh) / whole);
    }
    std::printf("\n");
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  try {
    const SegmentedModel model = io::read_segmented_model(io::read_document(argv[1]));
    std::vector<TriMesh> shapes;
    for (int i = 2; i < argc; ++i) shapes.push_back(io::read_mesh(io::read_document(argv[i])));
    print_volumes(model, shapes);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "part_volumes: %s\n", error.what());
    return 1;
  }
}
