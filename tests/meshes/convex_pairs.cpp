#include "convex_pairs.h"

#include <algorithm>
#include <limits>

#include "geometry/surface_index.h"
#include "mapping/build_hulls.h"

namespace partwise::tests {
namespace {

Points projected_to(const ConvexHull& hull, const Points& points) {
  const SurfaceIndex surface(hull.points, hull.facets);
  const Vec3 centre = hull_centre(hull);
  Points images;
  for (const Vec3& p : points) images.push_back(surface.first_hit(centre, p - centre)->position);
  return images;
}

SegmentedModel segmented(const TriMesh& mesh, std::vector<std::string> names, std::vector<int> labels) {
  return {mesh, trace_boundaries(mesh, std::move(names), std::move(labels)), {}, {}, {}};
}

BoundaryPlacement nearest_placement(const SegmentedModel& target, int vertex, const Vec3& p) {
  BoundaryPlacement best{vertex, -1, -1, 0};
  double nearest = std::numeric_limits<double>::infinity();
  for (const BoundaryCurve& curve : target.segmentation.curves) {
    const std::size_t edges = curve.vertices.size() - (curve.closed ? 0 : 1);
    for (std::size_t i = 0; i < edges; ++i) {
      const int a = curve.vertices[i], b = curve.vertices[(i + 1) % curve.vertices.size()];
      const Vec3 from = target.mesh.point(a), along = target.mesh.point(b) - from;
      const double fraction = std::clamp((p - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
      const double distance = (from + fraction * along - p).norm();
      if (distance >= nearest) continue;
      nearest = distance;
      best = {vertex, a, b, fraction};
    }
  }
  return best;
}

}  // namespace

SegmentedModel whole(const TriMesh& mesh) {
  return segmented(mesh, {"all"}, std::vector<int>(mesh.facet_count(), 0));
}

SegmentedModel halves(const TriMesh& mesh) {
  std::vector<int> labels;
  for (const Facet& f : mesh.facets()) {
    labels.push_back(mesh.point(f[0]).z() + mesh.point(f[1]).z() + mesh.point(f[2]).z() > 0 ? 1 : 0);
  }
  return segmented(mesh, {"below", "above"}, std::move(labels));
}

HullMap projected(const SegmentedModel& model) {
  HullMap map{build_hulls(model), {}};
  for (std::size_t k = 0; k < map.hulled.parts.size(); ++k) {
    map.images.push_back(projected_to(map.hulled.hulls[k], map.hulled.parts[k].mesh.points()));
  }
  return map;
}

CrossMap projected_pair(const SegmentedModel& source, const SegmentedModel& target,
                        std::vector<MarkerPair> markers) {
  CrossMap map{source, projected(target), {}, {}, {}, std::move(markers)};
  std::vector<int> on_curves;
  for (int k = 0; k < source.segmentation.part_count(); ++k) {
    map.source_parts.push_back(extract_part(source, k));
    map.images.push_back(projected_to(map.target.hulled.hulls[k], map.source_parts[k].mesh.points()));
  }
  for (const BoundaryCurve& curve : source.segmentation.curves) {
    on_curves.insert(on_curves.end(), curve.vertices.begin(), curve.vertices.end());
  }
  std::sort(on_curves.begin(), on_curves.end());
  on_curves.erase(std::unique(on_curves.begin(), on_curves.end()), on_curves.end());
  for (const int v : on_curves) map.boundary.push_back(nearest_placement(target, v, source.mesh.point(v)));
  return map;
}

}  // namespace partwise::tests
