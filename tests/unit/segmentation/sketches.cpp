#include "segmentation/sketches.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "builders.h"

namespace partwise::tests {

int vertex_near(const TriMesh& mesh, const Vec3& place) {
  int best = 0;
  for (int v = 1; v < mesh.vertex_count(); ++v) {
    if ((mesh.point(v) - place).norm() < (mesh.point(best) - place).norm()) best = v;
  }
  return best;
}

SketchedPart part_at(const TriMesh& mesh, const std::string& name, const std::vector<Vec3>& places) {
  VertexStroke stroke;
  for (const Vec3& place : places) stroke.vertices.push_back(vertex_near(mesh, place));
  return {name, {stroke}};
}

Renumbered renumbered(const TriMesh& mesh, unsigned seed) {
  std::mt19937 random(seed);
  auto shuffled = [&](int count) {
    std::vector<int> order(count);
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), random);
    return order;
  };
  const std::vector<int> new_vertex = shuffled(mesh.vertex_count());
  const std::vector<int> new_facet = shuffled(mesh.facet_count());
  Points points(mesh.vertex_count());
  for (int v = 0; v < mesh.vertex_count(); ++v) points[new_vertex[v]] = mesh.point(v);
  Facets facets(mesh.facet_count());
  for (int f = 0; f < mesh.facet_count(); ++f) {
    const auto& [a, b, c] = mesh.facet(f);
    facets[new_facet[f]] = {new_vertex[b], new_vertex[c], new_vertex[a]};
  }
  return {TriMesh(std::move(points), std::move(facets)), new_vertex, new_facet};
}

TriMesh irregular_body() {
  const TriMesh ball = sphere(20);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> noise(-0.01, 0.01);
  Points points;
  for (const Vec3& p : ball.points()) {
    const double waist = 1 - 0.55 * std::exp(-8 * std::pow(p.z() - 0.1, 2));
    Vec3 q(p.x() * waist + 0.2 * p.z() * p.z(), 0.9 * p.y() * waist + 0.05 * p.x(), 1.7 * p.z());
    for (int axis = 0; axis < 3; ++axis) q[axis] += noise(random);
    points.push_back(q);
  }
  return ball.with_points(std::move(points));
}

Sketch body_sketch(const TriMesh& body) {
  Sketch sketch;
  sketch.parts = {part_at(body, "bottom", {{0, 0, -2}, {0.9, 0, -1}, {-0.8, 0, -1}}),
                  part_at(body, "top", {{0, 0, 2}, {-0.5, 0.3, 1.1}}),
                  part_at(body, "side", {{1, 0.3, 1}, {1.2, 0, 0.8}})};
  sketch.markers = {{"tip", vertex_near(body, {0, 0, 2})}};
  sketch.anchors = {{"front", {"bottom", "top"}, vertex_near(body, {0, -1, 0.1})}};
  return sketch;
}

}  // namespace partwise::tests
