#include "stage_samples.h"

#include <algorithm>
#include <random>
#include <set>
#include <utility>

#include "builders.h"
#include "remeshing/split_source.h"

namespace partwise::tests {
namespace {

Vec3 centroid(const TriMesh& mesh, int facet) {
  return position(mesh, {facet, Vec3::Constant(1.0 / 3)});
}

/// 0 above, 1 and 2 below for x > 0 and x < 0.
std::vector<int> three_way_labels(const TriMesh& mesh) {
  std::vector<int> labels;
  for (int f = 0; f < mesh.facet_count(); ++f) {
    const Vec3 c = centroid(mesh, f);
    labels.push_back(c.z() > 0 ? 0 : c.x() > 0 ? 1 : 2);
  }
  return labels;
}

SurfacePoint some_point(int facet, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  const Vec3 weights(uniform(random), uniform(random), uniform(random));
  return {facet, weights / weights.sum()};
}

}  // namespace

SegmentedModel sample_segmented_model(int n) {
  const TriMesh mesh = sphere(n);
  SegmentedModel model{
      mesh,
      trace_boundaries(mesh, {"top", "left \"leg\"", "Schw\u00e4nzchen"}, three_way_labels(mesh)),
      {},
      {},
      {}};
  std::mt19937 random(1);
  model.markers = {{"nose", some_point(3, random)}, {"chin", {0, Vec3(1, 0, 0)}}};
  const BoundaryCurve& curve = model.segmentation.curves.front();
  model.anchors = {{"front", curve.right, curve.left, curve.vertices[1], 0.1 / 3, false},
                   {"", curve.left, curve.right, curve.vertices.back(), 0, true}};
  for (int k = 0; k < 3; ++k) model.concavity.push_back({(k + 1) / 7.0, 1 / (3.0 + k), k - 1});
  return model;
}

SegmentedModel sample_open_model() {
  const TriMesh mesh = hemisphere(4);
  std::vector<int> labels;
  for (int f = 0; f < mesh.facet_count(); ++f) labels.push_back(centroid(mesh, f).x() > 0 ? 1 : 0);
  SegmentedModel model{mesh, trace_boundaries(mesh, {"a", "b"}, labels), {}, {}, {}};
  for (const BoundaryCurve& curve : model.segmentation.curves) {
    model.anchors.push_back({"rim", curve.left, curve.right, curve.vertices[1], 0, false});
  }
  return model;
}

HulledModel sample_hulled_model() {
  HulledModel hulled{sample_segmented_model(), {}, {}};
  for (int k = 0; k < 3; ++k) {
    Part part = extract_part(hulled.model, k);
    // The vertices backwards: their order must survive.
    const int last = part.mesh.vertex_count() - 1;
    ConvexHull hull;
    for (int v = 0; v <= last; ++v) {
      hull.points.push_back(part.mesh.point(last - v));
      hull.part_vertex.push_back(last - v);
    }
    for (const Facet& f : part.mesh.facets()) hull.facets.push_back({last - f[0], last - f[1], last - f[2]});
    hulled.parts.push_back(std::move(part));
    hulled.hulls.push_back(std::move(hull));
  }
  return hulled;
}

HullMap sample_hull_map() {
  HullMap map{sample_hulled_model(), {}};
  for (const Part& part : map.hulled.parts) {
    Points images = part.mesh.points();
    for (Vec3& image : images) image = image / 3 + Vec3(0.1, 0.2, -0.3);
    map.images.push_back(std::move(images));
  }
  return map;
}

CrossMap sample_cross_map() {
  SegmentedModel source = sample_segmented_model(6);
  const HullMap target = sample_hull_map();
  std::vector<std::string> names = source.segmentation.names;
  std::vector<int> labels = source.segmentation.labels;
  std::reverse(names.begin(), names.end());
  for (int& label : labels) label = 2 - label;
  source.segmentation = trace_boundaries(source.mesh, names, labels);
  for (Anchor& anchor : source.anchors) {
    anchor.part_a = 2 - anchor.part_a;
    anchor.part_b = 2 - anchor.part_b;
  }

  CrossMap map{source, target, {}, {}, {}, {}};
  for (const std::string& name : target.hulled.model.segmentation.names) {
    Part part = extract_part(source, part_index(source.segmentation, name));
    Points images = part.mesh.points();
    for (Vec3& image : images) image = image / 7;
    map.source_parts.push_back(std::move(part));
    map.images.push_back(std::move(images));
  }
  std::set<int> boundary;
  for (const BoundaryCurve& curve : source.segmentation.curves) {
    boundary.insert(curve.vertices.begin(), curve.vertices.end());
  }
  const BoundaryCurve& curve = target.hulled.model.segmentation.curves.front();
  for (const int vertex : boundary) {
    map.boundary.push_back({vertex, curve.vertices[1], curve.vertices[0], 1 / (2.0 + vertex)});
  }
  std::mt19937 random(2);
  map.markers = {{"nose", some_point(5, random), some_point(9, random)}};
  return map;
}

CompatibleMesh sample_compatible_mesh() {
  const TriMesh source = sphere(4);
  const TriMesh target = bumpy_sphere(6, 0.3);
  std::mt19937 random(3);
  std::vector<SurfacePoint> images;
  for (int v = 0; v < source.vertex_count(); ++v) {
    images.push_back(some_point(static_cast<int>(random() % target.facet_count()), random));
  }
  SurfaceMap map(source, target, images);
  Points points = map.positions(target);
  CompatibleMesh mesh{source,
                      target,
                      std::move(points),
                      std::move(map),
                      three_way_labels(source),
                      three_way_labels(target),
                      {"top", "left", "right"},
                      {{"nose", some_point(1, random), some_point(2, random)}},
                      {{7, -0.1, 2.0 / 3, {2, 7, 9}}, {3, 1e-300, 0, {3}}}};
  // Their directions need not make a map: documents say what is there, certificates whether it holds.
  for (const std::vector<int>& parts : {std::vector<int>{0, 2}, std::vector<int>{1}}) {
    Chart chart{parts, {}};
    const Part piece = extract_piece(target, facets_of(chart, mesh.target_labels));
    for (const Vec3& point : piece.mesh.points()) chart.directions.push_back(point / 3 + Vec3(0, 0, 0.1));
    mesh.charts.push_back(std::move(chart));
  }
  const Facet& f = source.facet(3);
  mesh.added_vertices = {{{f[0], f[1], 1.0 / 3}, some_point(8, random)},
                         {{f[2], f[1], 0.25}, some_point(0, random)}};
  for (int v = 0; v < target.vertex_count(); ++v) {
    mesh.inverse.push_back(some_point(static_cast<int>(random() % source.facet_count()), random));
  }
  return mesh;
}

CompatibleMesh sample_refined_mesh() {
  CompatibleMesh mesh = sample_compatible_mesh();
  mesh.charts.clear();
  mesh.added_vertices.clear();
  mesh.inverse.clear();
  const Facet first = mesh.source.facet(0), second = mesh.source.facet(5);
  mesh = split_source(mesh, {{first[0], first[1], 0.25}, {second[2], second[0], 0.5}});
  const int added = mesh.source.vertex_count() - 2;
  return split_source(mesh, {{first[0], added, 0.5}, {first[2], added, 0.75}});
}

}  // namespace partwise::tests
