#include "segmentation/anchor_proposals.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "geometry/normals.h"
#include "segmentation/mirrored_anchors.h"

namespace partwise {
namespace {

constexpr double kNearMarker = 0.15;       // of the curve's length
constexpr double kLeastInclination = 0.3;  // share of a direction that lies in the curve's plane

/// A closed curve as a polygon in space.
struct Loop {
  const std::vector<int>& vertices;
  double length;
  Vec3 centre = Vec3::Zero();
  Vec3 normal = Vec3::Zero();  ///< unit, or zero for a curve without area

  Loop(const TriMesh& mesh, const BoundaryCurve& curve) : vertices(curve.vertices), length(curve.length) {
    for (const int v : vertices) centre += mesh.point(v) / static_cast<double>(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Vec3 a = mesh.point(vertices[i]) - centre;
      const Vec3 b = mesh.point(vertices[(i + 1) % vertices.size()]) - centre;
      normal += a.cross(b);
    }
    normal.normalize();
  }
};

/// Which way along the loop's plane a proposal looks, and what it is called after.
struct Heading {
  std::string there;  ///< "near nose tip", "towards head"
  std::string back;   ///< "away from ..."
  Vec3 direction;     ///< unit, in the loop's plane
};

Points part_centroids(const TriMesh& mesh, const Segmentation& segmentation) {
  const std::vector<double> areas = facet_areas(mesh.points(), mesh.facets());
  Points sums(segmentation.part_count(), Vec3::Zero());
  std::vector<double> totals(segmentation.part_count());
  for (int f = 0; f < mesh.facet_count(); ++f) {
    const int part = segmentation.labels[f];
    sums[part] += areas[f] * position(mesh, {f, Vec3::Constant(1 / 3.0)});
    totals[part] += areas[f];
  }
  for (std::size_t part = 0; part < sums.size(); ++part) {
    if (totals[part] > 0) sums[part] /= totals[part];
  }
  return sums;
}

std::optional<Heading> heading_to_marker(const TriMesh& mesh, const Loop& loop,
                                         const std::vector<Marker>& markers) {
  std::optional<Heading> best;
  double nearest = kNearMarker * loop.length;
  for (const Marker& marker : markers) {
    const Vec3 place = position(mesh, marker.point);
    double distance = nearest;
    for (const int v : loop.vertices) distance = std::min(distance, (mesh.point(v) - place).norm());
    const Vec3 away = place - loop.centre;
    const Vec3 direction = away - away.dot(loop.normal) * loop.normal;
    if (distance >= nearest || direction.norm() < kLeastInclination * away.norm()) continue;
    nearest = distance;
    best = {"near " + marker.name, "away from " + marker.name, direction.normalized()};
  }
  return best;
}

std::optional<Heading> heading_to_part(const Loop& loop, const BoundaryCurve& curve,
                                       const Segmentation& segmentation, const Points& centroids) {
  std::optional<Heading> best;
  double inclination = kLeastInclination;
  for (int part = 0; part < segmentation.part_count(); ++part) {
    if (part == curve.left || part == curve.right) continue;
    const Vec3 away = centroids[part] - loop.centre;
    const Vec3 direction = away - away.dot(loop.normal) * loop.normal;
    if (!(away.norm() > 0) || direction.norm() <= inclination * away.norm()) continue;
    inclination = direction.norm() / away.norm();
    const std::string& name = segmentation.names[part];
    best = {"towards " + name, "away from " + name, direction.normalized()};
  }
  return best;
}

int farthest_vertex(const TriMesh& mesh, const Loop& loop, const Vec3& direction) {
  return *std::max_element(loop.vertices.begin(), loop.vertices.end(), [&](int a, int b) {
    return direction.dot(mesh.point(a)) < direction.dot(mesh.point(b));
  });
}

bool needs_anchors(const Segmentation& segmentation, const BoundaryCurve& curve,
                   const std::vector<Anchor>& anchors) {
  if (!curve.closed || curve.right == kOutside) return false;
  const auto alike =
      std::count_if(segmentation.curves.begin(), segmentation.curves.end(), [&](const BoundaryCurve& other) {
        return other.closed && other.left == curve.left && other.right == curve.right;
      });
  const auto held = std::count_if(anchors.begin(), anchors.end(), [&](const Anchor& anchor) {
    return std::count(curve.vertices.begin(), curve.vertices.end(), anchor.vertex) > 0;
  });
  return alike == 1 && held < 2;
}

}  // namespace

std::vector<Anchor> propose_anchors(const TriMesh& mesh, const Segmentation& segmentation,
                                    const std::vector<Marker>& markers, const std::vector<Anchor>& anchors) {
  const Points centroids = part_centroids(mesh, segmentation);
  std::vector<Anchor> proposals;
  for (const BoundaryCurve& curve : segmentation.curves) {
    if (!needs_anchors(segmentation, curve, anchors)) continue;
    const std::vector<Anchor> mirrored = mirrored_anchors(mesh, segmentation, curve, anchors, centroids);
    proposals.insert(proposals.end(), mirrored.begin(), mirrored.end());
    if (!mirrored.empty()) continue;
    const Loop loop(mesh, curve);
    std::optional<Heading> heading = heading_to_marker(mesh, loop, markers);
    if (!heading) heading = heading_to_part(loop, curve, segmentation, centroids);
    if (!heading) continue;
    const std::string& a = segmentation.names[curve.left];
    const std::string& b = segmentation.names[curve.right];
    const std::string pair = std::min(a, b) + "-" + std::max(a, b) + " ";
    const int first = farthest_vertex(mesh, loop, heading->direction);
    const int second = farthest_vertex(mesh, loop, -heading->direction);
    proposals.push_back({pair + heading->there + " (proposed)", curve.left, curve.right, first, 0, true});
    proposals.push_back({pair + heading->back + " (proposed)", curve.left, curve.right, second, 0, true});
  }
  return proposals;
}

}  // namespace partwise
