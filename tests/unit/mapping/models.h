#pragma once

#include <string>
#include <vector>

#include "builders.h"
#include "mesh/segmentation.h"

/// Segmented models of known shape for the tests of the mappings.
namespace partwise::tests {

/// `mesh` cut by the planes x = 0, y = 0, z = 0 (the first `axes` of them): part names "p0", "p1", ...; bit k
/// of the number is set where coordinate k is negative.
inline SegmentedModel octant_model(const TriMesh& mesh, int axes) {
  std::vector<int> labels;
  for (const Facet& f : mesh.facets()) {
    const Vec3 sum = mesh.point(f[0]) + mesh.point(f[1]) + mesh.point(f[2]);
    int label = 0;
    for (int axis = 0; axis < axes; ++axis) label |= (sum[axis] < 0 ? 1 : 0) << axis;
    labels.push_back(label);
  }
  std::vector<std::string> names;
  for (int part = 0; part < 1 << axes; ++part) names.push_back("p" + std::to_string(part));
  return {mesh, trace_boundaries(mesh, names, labels), {}, {}, {}};
}

/// The model moved by `motion`, its vertices in reverse order and its parts too: the same shape to every
/// question that does not ask for indices.
inline SegmentedModel reindexed(const SegmentedModel& model, const Eigen::Affine3d& motion) {
  const int n = model.mesh.vertex_count(), parts = model.segmentation.part_count();
  Points points(n);
  for (int v = 0; v < n; ++v) points[n - 1 - v] = motion * model.mesh.point(v);
  Facets facets = model.mesh.facets();
  for (Facet& f : facets) f = {n - 1 - f[0], n - 1 - f[1], n - 1 - f[2]};
  std::vector<int> labels = model.segmentation.labels;
  for (int& label : labels) label = parts - 1 - label;
  std::vector<std::string> names(model.segmentation.names.rbegin(), model.segmentation.names.rend());
  SegmentedModel copy{TriMesh(points, facets), {}, model.markers, model.anchors, model.concavity};
  copy.segmentation = trace_boundaries(copy.mesh, names, labels);
  for (Anchor& a : copy.anchors) {
    a = {a.name, parts - 1 - a.part_a, parts - 1 - a.part_b, n - 1 - a.vertex, a.snap_distance, a.proposed};
  }
  return copy;
}

/// Turns, scales by 1000 and moves.
inline Eigen::Affine3d some_similarity() {
  return Eigen::Translation3d(30, -70, 1100) * Eigen::AngleAxisd(2.1, Vec3(1, -2, 0.5).normalized()) *
         Eigen::Scaling(1000.0);
}

/// A lumpy ball without symmetries.
inline TriMesh lumpy_sphere(int n) {
  const TriMesh round = sphere(n);
  Points points = round.points();
  for (Vec3& p : points) {
    p *= 1 + 0.2 * p.x() + 0.15 * std::sin(3 * p.y() + 0.4) + 0.1 * std::cos(2 * p.z() * p.x());
    p = p.cwiseProduct(Vec3(1.6, 1.2, 0.9));
  }
  return round.with_points(points);
}

}  // namespace partwise::tests
