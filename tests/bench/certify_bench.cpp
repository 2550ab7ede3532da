// Meshes and repeated runs for the script certify: see there.
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <map>
#include <numeric>
#include <random>
#include <string>

#include "io/mesh_files.h"
#include "io/stage_documents.h"
#include "mapping/build_hulls.h"
#include "mapping/hull_to_hull.h"
#include "mapping/map_to_hull.h"

namespace {

using namespace partwise;

/// Every facet in four, without smoothing.
TriMesh subdivided(const TriMesh& mesh) {
  Points points = mesh.points();
  std::map<std::array<int, 2>, int> middles;
  auto middle = [&](int a, int b) {
    const auto [entry, is_new] =
        middles.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<int>(points.size()));
    if (is_new) points.push_back((mesh.point(a) + mesh.point(b)) / 2);
    return entry->second;
  };
  Facets facets;
  for (const auto& [a, b, c] : mesh.facets()) {
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    facets.insert(facets.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return {std::move(points), std::move(facets)};
}

/// A model elsewhere, in another size, with other numbers.
struct Moved {
  SegmentedModel model;
  Eigen::Affine3d motion;
  std::vector<int> new_vertex;
};

std::vector<int> shuffled(int count, std::mt19937& random) {
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  for (int i = count - 1; i > 0; --i) std::swap(order[i], order[random() % (i + 1)]);
  return order;
}

Moved moved(const SegmentedModel& model, std::mt19937& random) {
  auto between = [&](double low, double high) { return low + (high - low) * (random() / 4294967296.0); };
  const Vec3 axis = Vec3(between(-1, 1), between(-1, 1), between(-1, 1) + 1e-3).normalized();
  const double scale = std::pow(10, between(-3, 3)), l = scale * model.mesh.diagonal();
  Eigen::Affine3d motion = Eigen::Translation3d(l * between(-2, 2), l * between(-2, 2), l * between(-2, 2)) *
                           Eigen::AngleAxisd(between(0, 2 * M_PI), axis) * Eigen::Scaling(scale);
  const std::vector<int> vertex = shuffled(model.mesh.vertex_count(), random);
  const std::vector<int> facet = shuffled(model.mesh.facet_count(), random);
  Points points(vertex.size());
  for (std::size_t v = 0; v < vertex.size(); ++v) points[vertex[v]] = motion * model.mesh.points()[v];
  Facets facets(facet.size());
  std::vector<int> labels(facet.size());
  for (std::size_t f = 0; f < facet.size(); ++f) {
    const auto& [a, b, c] = model.mesh.facets()[f];
    facets[facet[f]] = {vertex[a], vertex[b], vertex[c]};
    labels[facet[f]] = model.segmentation.labels[f];
  }
  const TriMesh mesh(points, facets);
  SegmentedModel copy{
      mesh, trace_boundaries(mesh, model.segmentation.names, labels), model.markers, model.anchors, {}};
  for (Marker& marker : copy.markers) marker.point.facet = facet[marker.point.facet];
  for (Anchor& anchor : copy.anchors) anchor.vertex = vertex[anchor.vertex];
  return {std::move(copy), motion, vertex};
}

/// How a pair came out: parts and maps without a certificate, and the source's vertices on the target's
/// hulls.
struct Outcome {
  int uncertified = 0;
  std::vector<std::map<int, Vec3>> images;  ///< per part, by the model's vertex
};

HullMap mapped(const SegmentedModel& model, int& uncertified) {
  MappedToHull result = map_to_hull(build_hulls(model));
  for (const PartMapReport& report : result.reports) uncertified += report.one_to_one ? 0 : 1;
  return std::move(result.map);
}

Outcome run(const SegmentedModel& source, const SegmentedModel& target) {
  Outcome outcome;
  const HullMap source_map = mapped(source, outcome.uncertified);
  const HullMap target_map = mapped(target, outcome.uncertified);
  const HullToHull result = map_hull_to_hull(source_map, target_map);
  for (std::size_t k = 0; k < result.parts.size(); ++k) {
    outcome.uncertified += result.parts[k].one_to_one ? 0 : 1;
    std::map<int, Vec3>& images = outcome.images.emplace_back();
    const std::vector<int>& vertices = result.map.source_parts[k].model_vertex;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      if (vertices[v] >= 0) images.emplace(vertices[v], result.map.images[k][v]);
    }
  }
  return outcome;
}

int compare_moves(const SegmentedModel& source, const SegmentedModel& target, int count) {
  const Outcome before = run(source, target);
  std::mt19937 random(20110917);
  int uncertified = before.uncertified, alike = 0;
  double largest = 0;
  std::vector<double> distances;
  for (int i = 0; i < count; ++i) {
    const Moved s = moved(source, random), t = moved(target, random);
    const Outcome after = run(s.model, t.model);
    uncertified += after.uncertified;
    const Eigen::Affine3d back = t.motion.inverse();
    double farthest = 0;
    for (std::size_t k = 0; k < before.images.size(); ++k) {
      for (const auto& [v, image] : before.images[k]) {
        const double d = (back * after.images[k].at(s.new_vertex[v]) - image).norm() / target.mesh.diagonal();
        farthest = std::max(farthest, d);
        distances.push_back(d);
      }
    }
    alike += farthest < 1e-6 ? 1 : 0;
    largest = std::max(largest, farthest);
  }
  std::sort(distances.begin(), distances.end());
  const double median = distances.empty() ? 0 : distances[distances.size() / 2];
  const double high = distances.empty() ? 0 : distances[distances.size() * 99 / 100];
  std::printf(
      "%d moves: %d parts uncertified, %d equal within 1e-6 l; distance median %.2g, 99 %% %.2g, largest "
      "%.2g l\n",
      count, uncertified, alike, median, high, largest);
  return uncertified == 0 ? 0 : 1;
}

int run_command(const std::vector<std::string>& words) {
  if (words.size() == 4 && words[0] == "subdivide") {
    TriMesh mesh = io::read_mesh(io::read_document(words[1]));
    for (int i = 0; i < std::stoi(words[2]); ++i) mesh = subdivided(mesh);
    io::export_mesh(words[3], mesh.points(), mesh.facets(), true);
    return 0;
  }
  if (words.size() == 4 && words[0] == "move") {
    return compare_moves(io::read_segmented_model(io::read_document(words[1])),
                         io::read_segmented_model(io::read_document(words[2])), std::stoi(words[3]));
  }
  std::fputs("certify_bench subdivide MESH TIMES OUT | move SOURCE TARGET COUNT\n", stderr);
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run_command({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "certify_bench: %s\n", error.what());
    return 1;
  }
}
