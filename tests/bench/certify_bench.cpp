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
#include "measure/certificate.h"
#include "remeshing/reconstruct.h"

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

/// Where a stage puts the vertices of one part, or of the whole mesh.
struct Piece {
  std::string name;
  bool certified = false;
  std::map<int, Vec3> images;  ///< by the vertex of the model that is mapped
};

struct Stage {
  std::string name;
  bool of_target = false;  ///< it is the target that is mapped
  bool in_target = false;  ///< images are in the target's space
  std::vector<Piece> pieces;
};

std::map<int, Vec3> by_model_vertex(const std::vector<int>& model_vertex, const Points& images) {
  std::map<int, Vec3> result;
  for (std::size_t v = 0; v < model_vertex.size(); ++v) {
    if (model_vertex[v] >= 0) result.emplace(model_vertex[v], images[v]);
  }
  return result;
}

Stage hull_stage(const std::string& name, bool target, const MappedToHull& mapped) {
  Stage stage{name, target, target, {}};
  for (std::size_t k = 0; k < mapped.reports.size(); ++k) {
    stage.pieces.push_back({mapped.map.hulled.model.segmentation.names[k], mapped.reports[k].one_to_one,
                            by_model_vertex(mapped.map.hulled.parts[k].model_vertex, mapped.map.images[k])});
  }
  return stage;
}

Stage cross_stage(const HullToHull& crossed) {
  Stage stage{"hull-to-hull", false, true, {}};
  for (std::size_t k = 0; k < crossed.parts.size(); ++k) {
    stage.pieces.push_back(
        {crossed.parts[k].name, crossed.parts[k].one_to_one,
         by_model_vertex(crossed.map.source_parts[k].model_vertex, crossed.map.images[k])});
  }
  return stage;
}

Stage whole_stage(const CompatibleMesh& mesh) {
  std::vector<int> all(mesh.points.size());
  std::iota(all.begin(), all.end(), 0);
  return {
      "reconstruct", false, true, {{"whole", certify(mesh).one_to_one(), by_model_vertex(all, mesh.points)}}};
}

std::vector<Stage> run(const SegmentedModel& source, const SegmentedModel& target) {
  const MappedToHull source_map = map_to_hull(build_hulls(source)),
                     target_map = map_to_hull(build_hulls(target));
  const HullToHull crossed = map_hull_to_hull(source_map.map, target_map.map);
  return {hull_stage("map-to-hull, source", false, source_map),
          hull_stage("map-to-hull, target", true, target_map), cross_stage(crossed),
          whole_stage(reconstruct(crossed.map).mesh)};
}

/// What the moved runs say of one stage.
struct Comparison {
  int pieces = 0, certified = 0;
  int alike = 0;  ///< runs within kAlike
  std::vector<double>
      distances;  ///< of the vertices to where the run without moves has them, over the diagonal
  double largest = 0;
  std::string farthest;  ///< piece
};

constexpr double kAlike = 1e-6;

void compare(const Stage& before, const Stage& after, const std::vector<int>& new_vertex,
             const Eigen::Affine3d& back, double diagonal, Comparison& result) {
  double largest = 0;
  for (std::size_t k = 0; k < before.pieces.size(); ++k) {
    ++result.pieces;
    result.certified += after.pieces[k].certified ? 1 : 0;
    for (const auto& [v, image] : before.pieces[k].images) {
      const double d = (back * after.pieces[k].images.at(new_vertex[v]) - image).norm() / diagonal;
      result.distances.push_back(d);
      largest = std::max(largest, d);
      if (d > result.largest) {
        result.largest = d;
        result.farthest = before.pieces[k].name;
      }
    }
  }
  result.alike += largest < kAlike ? 1 : 0;
}

int compare_moves(const SegmentedModel& source, const SegmentedModel& target, int count) {
  const std::vector<Stage> before = run(source, target);
  std::vector<Comparison> found(before.size());
  std::mt19937 random(20110917);
  for (int i = 0; i < count; ++i) {
    const Moved s = moved(source, random), t = moved(target, random);
    const std::vector<Stage> after = run(s.model, t.model);
    for (std::size_t k = 0; k < before.size(); ++k) {
      const Moved& mapped = before[k].of_target ? t : s;
      const Moved& space = before[k].in_target ? t : s;
      compare(before[k], after[k], mapped.new_vertex, space.motion.inverse(),
              (before[k].in_target ? target : source).mesh.diagonal(), found[k]);
    }
  }
  std::printf("%-20s %9s %6s %6s %8s %8s %8s  %s\n", "stage", "certified", "of", "equal", "median", "99 %",
              "largest", "(over l)");
  bool all = true;
  for (std::size_t k = 0; k < before.size(); ++k) {
    std::vector<double>& distances = found[k].distances;
    std::sort(distances.begin(), distances.end());
    std::printf("%-20s %9d %6d %6d %8.1e %8.1e %8.1e  %s\n", before[k].name.c_str(), found[k].certified,
                found[k].pieces, found[k].alike, distances[distances.size() / 2],
                distances[distances.size() / 100 * 99], found[k].largest, found[k].farthest.c_str());
    all = all && found[k].certified == found[k].pieces;
  }
  return all ? 0 : 1;
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
