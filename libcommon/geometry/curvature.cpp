#include "geometry/curvature.h"

#include <array>
#include <cmath>
#include <numbers>

#include "geometry/normals.h"

namespace partwise {
namespace {

/// Shares of a facet's area for its three corners: Voronoi regions, or one half for an obtuse corner and one
/// quarter each for the two others.
std::array<double, 3> corner_areas(const std::array<Vec3, 3>& corners) {
  const double twice_area = area_vector(corners[0], corners[1], corners[2]).norm();
  std::array<double, 3> cosine{};  // times the lengths of both edges
  std::array<double, 3> opposite{};
  for (int i = 0; i < 3; ++i) {
    const Vec3 &a = corners[i], &b = corners[(i + 1) % 3], &c = corners[(i + 2) % 3];
    cosine[i] = (b - a).dot(c - a);
    opposite[i] = (c - b).squaredNorm();
  }
  for (int i = 0; i < 3; ++i) {
    if (cosine[i] >= 0) continue;
    std::array<double, 3> shares{};
    for (int j = 0; j < 3; ++j) shares[j] = twice_area * (j == i ? 0.25 : 0.125);
    return shares;
  }
  std::array<double, 3> shares{};
  if (twice_area == 0) return shares;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    // Of each edge at corner i, the cotangent of the angle facing it.
    shares[i] = (opposite[j] * cosine[j] + opposite[k] * cosine[k]) / (8 * twice_area);
  }
  return shares;
}

std::array<Vec3, 3> corners_of(const TriMesh& mesh, const Facet& f) {
  return {mesh.point(f[0]), mesh.point(f[1]), mesh.point(f[2])};
}

}  // namespace

std::vector<double> angle_defects(const TriMesh& mesh) {
  std::vector<double> defects(mesh.vertex_count());
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const bool on_boundary = mesh.half_edges().is_boundary(OpenMesh::VertexHandle(v));
    defects[v] = (on_boundary ? 1 : 2) * std::numbers::pi;
  }
  for (const Facet& f : mesh.facets()) {
    const std::array<Vec3, 3> p = corners_of(mesh, f);
    for (int i = 0; i < 3; ++i) {
      const Vec3 u = p[(i + 1) % 3] - p[i], w = p[(i + 2) % 3] - p[i];
      defects[f[i]] -= std::atan2(u.cross(w).norm(), u.dot(w));
    }
  }
  return defects;
}

std::vector<double> mixed_areas(const TriMesh& mesh) {
  std::vector<double> areas(mesh.vertex_count(), 0.0);
  for (const Facet& f : mesh.facets()) {
    const std::array<double, 3> shares = corner_areas(corners_of(mesh, f));
    for (int i = 0; i < 3; ++i) areas[f[i]] += shares[i];
  }
  return areas;
}

std::vector<double> gaussian_curvature(const TriMesh& mesh) {
  const std::vector<double> areas = mixed_areas(mesh);
  std::vector<double> curvature = angle_defects(mesh);
  for (int v = 0; v < mesh.vertex_count(); ++v) curvature[v] = areas[v] > 0 ? curvature[v] / areas[v] : 0;
  return curvature;
}

}  // namespace partwise
