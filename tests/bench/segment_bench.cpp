// Figures of the segmentation for models with a sketch: see tests/bench/segment, which runs this program.
//
//   segment_bench DRAWS METHOD NAME MESH.ply SKETCH.json [NAME MESH SKETCH ...]
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>

#include "error.h"
#include "io/sketch.h"
#include "io/stage_documents.h"
#include "mesh/curve_roughness.h"
#include "segmentation/compatibility.h"
#include "segmentation/segment_mesh.h"

namespace {

using namespace partwise;

/// 0 ... 1 from the generator's bits alone: distributions of the standard library differ between systems.
double uniform(std::mt19937& random) {
  return random() / 4294967296.0;
}

/// Every stroke cut to a contiguous piece of 60-100 % of its entries.
Sketch shortened(Sketch sketch, std::mt19937& random) {
  auto cut = [&](auto& entries) {
    const double share = 0.6 + 0.4 * uniform(random), place = uniform(random);
    const auto n = static_cast<std::ptrdiff_t>(entries.size());
    const auto kept = std::clamp<std::ptrdiff_t>(std::llround(share * static_cast<double>(n)), 1, n);
    const auto first =
        std::min(static_cast<std::ptrdiff_t>(place * static_cast<double>(n - kept + 1)), n - kept);
    entries = {entries.begin() + first, entries.begin() + first + kept};
  };
  for (SketchedPart& part : sketch.parts) {
    for (Stroke& stroke : part.strokes) {
      if (auto* vertices = std::get_if<VertexStroke>(&stroke)) cut(vertices->vertices);
      if (auto* points = std::get_if<PointStroke>(&stroke)) cut(points->points);
    }
  }
  return sketch;
}

/// One to three strokes per part through one to five vertices from anywhere.
Sketch noise(Sketch sketch, const TriMesh& mesh, std::mt19937& random) {
  for (SketchedPart& part : sketch.parts) {
    part.strokes.assign(1 + random() % 3, VertexStroke{});
    for (Stroke& stroke : part.strokes) {
      auto& vertices = std::get<VertexStroke>(stroke).vertices;
      vertices.resize(1 + random() % 5);
      for (int& v : vertices) v = static_cast<int>(uniform(random) * mesh.vertex_count());
    }
  }
  return sketch;
}

struct Outcomes {
  int valid = 0;  ///< boundaries are simple curves: segment_mesh returned, and traced again they are the same
  int refused = 0;  ///< the strokes contradict each other: said, nothing returned
  int failed = 0;   ///< boundaries could not be made simple: said, nothing returned
};

Outcomes segment_noise(const TriMesh& mesh, const Sketch& sketch, const SegmentationOptions& options,
                       int draws) {
  Outcomes outcomes;
  std::mt19937 random(2);
  for (int draw = 0; draw < draws; ++draw) {
    try {
      const Segmentation s = segment_mesh(mesh, noise(sketch, mesh, random), options).model.segmentation;
      trace_boundaries(mesh, s.names, s.labels);
      ++outcomes.valid;
    } catch (const InputError&) {
      ++outcomes.refused;
    } catch (const ComputationError&) {
      ++outcomes.failed;
    }
  }
  return outcomes;
}

int draws_that_keep(const SegmentedModel& whole, const Sketch& sketch, const SegmentationOptions& options,
                    int draws, const std::string& name) {
  int kept = 0;
  std::mt19937 random(1);
  for (int draw = 0; draw < draws; ++draw) {
    try {
      const SegmentedMesh part = segment_mesh(whole.mesh, shortened(sketch, random), options);
      const std::vector<std::string> differences = compare_segmentations(whole, part.model);
      if (differences.empty()) {
        ++kept;
      } else {
        std::fprintf(stderr, "%s, draw %d: %s\n", name.c_str(), draw, differences.front().c_str());
      }
    } catch (const Error& error) {
      std::fprintf(stderr, "%s, draw %d: %s\n", name.c_str(), draw, error.what());
    }
  }
  return kept;
}

void report(const std::string& name, const TriMesh& mesh, Sketch sketch, const SegmentationOptions& options,
            int draws) {
  sketch.markers.clear();
  sketch.anchors.clear();
  const auto start = std::chrono::steady_clock::now();
  const SegmentedMesh whole = segment_mesh(mesh, sketch, options);
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  const Segmentation& segmentation = whole.model.segmentation;
  std::printf("%-12s %7d %7zu %6zu %10.3f %8.0f", name.c_str(), mesh.facet_count(),
              segmentation.curves.size(), segmentation.cross_points.size(),
              mean_roughness(mesh, segmentation), time.count());
  if (draws > 0) {
    const int kept = draws_that_keep(whole.model, sketch, options, draws, name);
    const Outcomes outcomes = segment_noise(mesh, sketch, options, draws);
    std::printf(" %7.0f %% %8d %8d %7d", 100.0 * kept / draws, outcomes.valid, outcomes.refused,
                outcomes.failed);
  }
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 6 || argc % 3 != 0)
    return std::fputs("segment_bench: see tests/bench/segment --help\n", stderr), 2;
  const int draws = std::stoi(argv[1]);
  SegmentationOptions options;
  if (argv[2] == std::string("growth")) options.method = SegmentationMethod::growth;
  std::printf("%-12s %7s %7s %6s %10s %8s %9s %8s %8s %7s\n", "model", "facets", "curves", "cross",
              "roughness", "ms", "same", "valid", "refused", "failed");
  int status = 0;
  for (int i = 3; i + 2 < argc; i += 3) {
    try {
      report(argv[i], io::read_mesh(io::read_document(argv[i + 1])), io::read_sketch(argv[i + 2]), options,
             draws);
    } catch (const Error& error) {
      std::fprintf(stderr, "%s: %s\n", argv[i], error.what());
      status = 1;
    }
  }
  return status;
}
