#include "remeshing/locate.h"

#include <algorithm>

#include "error.h"
#include "mesh/surface_walk.h"

namespace partwise {
namespace {

Points relative_to(const Vec3& centre, Points points) {
  for (Vec3& p : points) p -= centre;
  return points;
}

double orientation_from_origin(const Points& points, const Facet& f) {
  const Vec3 &a = points[f[0]], &b = points[f[1]], &c = points[f[2]];
  return a.dot((b - a).cross(c - a));
}

}  // namespace

DomainLocator::DomainLocator(const Part& part, const Points& images, const Vec3& centre)
    : part_(part),
      centre_(centre),
      around_centre_(relative_to(centre, images)),
      index_(around_centre_, part.mesh.facets()) {}

std::vector<SurfacePoint> DomainLocator::locate(const Vec3& image) const {
  const Vec3 direction = image - centre_;
  std::vector<SurfacePoint> front, back;
  if (!direction.isZero(0)) {
    for (const SurfaceHit& hit : index_.all_hits(Vec3::Zero(), direction)) {
      const bool is_front = orientation_from_origin(around_centre_, part_.mesh.facet(hit.point.facet)) > 0;
      (is_front ? front : back).push_back(hit.point);
    }
  }
  std::vector<SurfacePoint>& found = front.empty() ? back : front;
  if (found.empty()) return {index_.closest(direction).point};
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.facet < b.facet; });
  return found;
}

SurfacePoint DomainLocator::on_model(const SurfacePoint& local) const {
  if (!part_.is_cap_facet(local.facet)) return {part_.model_facet[local.facet], local.barycentric};
  const Facet& cap = part_.mesh.facet(local.facet);
  SurfacePoint on_loop = local;
  for (int i = 0; i < 3; ++i) {
    if (part_.is_cap_vertex(cap[i])) on_loop.barycentric[i] = 0;
  }
  const double sum = on_loop.barycentric.sum();
  for (int i = 0; i < 3; ++i) {
    if (part_.is_cap_vertex(cap[i])) continue;
    on_loop.barycentric[i] = sum > 0 ? on_loop.barycentric[i] / sum : 0.5;
  }
  const HalfEdges& half_edges = part_.mesh.half_edges();
  for (const auto h : half_edges.fh_range(OpenMesh::FaceHandle(local.facet))) {
    const int beside = half_edges.face_handle(half_edges.opposite_halfedge_handle(h)).idx();
    if (beside < 0 || part_.is_cap_facet(beside)) continue;
    const SurfacePoint seen = seen_from(part_.mesh, on_loop, beside);
    return {part_.model_facet[beside], seen.barycentric};
  }
  throw ComputationError("a cap of part " + std::to_string(part_.index) +
                         " has no facet of the part beside it");
}

}  // namespace partwise
