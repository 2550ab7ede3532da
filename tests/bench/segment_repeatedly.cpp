// Times the segmentation of one model as a process that keeps it does: see segment-large.
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <limits>
#include <optional>
#include <string>

#include "io/sketch.h"
#include "io/stage_documents.h"
#include "segmentation/segmenter.h"

namespace {

using namespace partwise;

/// Seconds of processor time of this process, all threads together.
double processor_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

/// As many parts as asked for, each with one vertex as its stroke, far from those before.
Sketch spread_strokes(const TriMesh& mesh, int count) {
  Sketch sketch;
  std::vector<double> distance(mesh.vertex_count(), std::numeric_limits<double>::infinity());
  int farthest = 0;
  for (int part = 0; part < count; ++part) {
    sketch.parts.push_back({"part " + std::to_string(part), {VertexStroke{{farthest}}}});
    const Vec3 here = mesh.point(farthest);
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      distance[v] = std::min(distance[v], (mesh.point(v) - here).norm());
    }
    farthest = static_cast<int>(std::max_element(distance.begin(), distance.end()) - distance.begin());
  }
  return sketch;
}

/// Runs a step, prints its times, returns its result.
template <class Step>
auto timed(const char* what, const Step& step) {
  const double start = processor_seconds();
  const auto clock = std::chrono::steady_clock::now();
  auto result = step();
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - clock;
  std::printf("%-24s %8.3f s of clock, %8.3f s of processor, peak %6.0f MB\n", what, passed.count(),
              processor_seconds() - start, peak_megabytes());
  return result;
}

void run(const std::string& mesh_path, const std::string& sketch_path) {
  const TriMesh mesh =
      timed("read, build half-edges", [&] { return io::read_mesh(io::read_document(mesh_path)); });
  Sketch sketch = sketch_path.empty() ? spread_strokes(mesh, 7) : io::read_sketch(sketch_path);
  std::optional<Segmenter> segmenter;
  const SegmentedMesh first =
      timed("first segmentation", [&] { return segmenter.emplace(mesh).segment(sketch); });
  for (int further = 1; further <= 3; ++further) {
    // One vertex more, from the inside of the part it is drawn for: of a facet in the middle of the list.
    const std::vector<int>& labels = first.model.segmentation.labels;
    const auto middle = labels.begin() + static_cast<std::ptrdiff_t>(labels.size()) * further / 4;
    const int facet = static_cast<int>(std::find(middle, labels.end(), 0) - labels.begin());
    if (facet < mesh.facet_count()) {
      sketch.parts[0].strokes.emplace_back(VertexStroke{{mesh.facet(facet)[0]}});
    }
    timed("with a further stroke", [&] { return segmenter->segment(sketch); });
  }
  std::printf("%d facets, %d parts, %zu curves\n", mesh.facet_count(), first.model.segmentation.part_count(),
              first.model.segmentation.curves.size());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3) {
    std::fprintf(stderr, "usage: segment_repeatedly MESH.ply [SKETCH.json]\n");
    return 2;
  }
  try {
    run(argv[1], argc > 2 ? argv[2] : "");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "segment_repeatedly: %s\n", error.what());
    return 1;
  }
  return 0;
}
