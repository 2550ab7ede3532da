#include "segmentation/mirrored_anchors.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <utility>

namespace partwise {
namespace {

constexpr double kFarthest = 0.15;  // of the curve's length

/// The part with the mirrored name; a part whose name has no side is its own image. -1: there is none.
int mirrored_part(const Segmentation& segmentation, int part) {
  const std::optional<std::string> name = mirrored_name(segmentation.names[part]);
  return name ? part_index(segmentation, *name) : part;
}

/// Unit vector across the mirror, or zero when no parts come in pairs.
Vec3 mirror_normal(const Segmentation& segmentation, const Points& part_centroids) {
  Vec3 sum = Vec3::Zero();
  for (int part = 0; part < segmentation.part_count(); ++part) {
    const int image = mirrored_part(segmentation, part);
    std::string name = segmentation.names[part];
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
    if (image < 0 || image == part || name.find("left") == std::string::npos) continue;
    sum += (part_centroids[part] - part_centroids[image]).normalized();
  }
  return sum.norm() > 0 ? Vec3(sum.normalized()) : sum;
}

Vec3 centroid(const TriMesh& mesh, const std::vector<int>& vertices) {
  Vec3 sum = Vec3::Zero();
  for (const int v : vertices) sum += mesh.point(v);
  return sum / static_cast<double>(vertices.size());
}

/// The only closed curve between two parts, or null.
const BoundaryCurve* curve_between(const Segmentation& segmentation, int a, int b) {
  const BoundaryCurve* found = nullptr;
  for (const BoundaryCurve& curve : segmentation.curves) {
    if (std::minmax(curve.left, curve.right) != std::minmax(a, b)) continue;
    if (found != nullptr || !curve.closed) return nullptr;
    found = &curve;
  }
  return found;
}

}  // namespace

std::optional<std::string> mirrored_name(const std::string& name) {
  static const std::array<std::pair<std::string, std::string>, 6> kSides{{{"left", "right"},
                                                                          {"right", "left"},
                                                                          {"Left", "Right"},
                                                                          {"Right", "Left"},
                                                                          {"LEFT", "RIGHT"},
                                                                          {"RIGHT", "LEFT"}}};
  const auto is_letter = [&](std::size_t i) {
    return i < name.size() && std::isalpha(static_cast<unsigned char>(name[i])) != 0;
  };
  for (const auto& [side, other] : kSides) {
    const std::size_t at = name.find(side);
    if (at == std::string::npos || is_letter(at + side.size()) || (at > 0 && is_letter(at - 1))) continue;
    return name.substr(0, at) + other + name.substr(at + side.size());
  }
  return std::nullopt;
}

std::vector<Anchor> mirrored_anchors(const TriMesh& mesh, const Segmentation& segmentation,
                                     const BoundaryCurve& curve, const std::vector<Anchor>& anchors,
                                     const Points& part_centroids) {
  const int left = mirrored_part(segmentation, curve.left), right = mirrored_part(segmentation, curve.right);
  if (left < 0 || right < 0 || std::minmax(left, right) == std::minmax(curve.left, curve.right)) return {};
  const BoundaryCurve* const image = curve_between(segmentation, left, right);
  const Vec3 normal = mirror_normal(segmentation, part_centroids);
  if (image == nullptr || normal.isZero()) return {};
  const Vec3 here = centroid(mesh, curve.vertices), there = centroid(mesh, image->vertices);
  std::vector<Anchor> result;
  for (const Anchor& anchor : anchors) {
    const std::vector<int>& held = image->vertices;
    const std::optional<std::string> name = mirrored_name(anchor.name);
    if (!name || anchor.proposed || std::find(held.begin(), held.end(), anchor.vertex) == held.end())
      continue;
    if (std::any_of(anchors.begin(), anchors.end(), [&](const Anchor& a) { return a.name == *name; }))
      continue;
    const Vec3 away = mesh.point(anchor.vertex) - there;
    const Vec3 place = here + away - 2 * away.dot(normal) * normal;
    const int nearest = *std::min_element(curve.vertices.begin(), curve.vertices.end(), [&](int a, int b) {
      return (mesh.point(a) - place).squaredNorm() < (mesh.point(b) - place).squaredNorm();
    });
    if ((mesh.point(nearest) - place).norm() > kFarthest * curve.length) continue;
    result.push_back({*name + " (proposed)", curve.left, curve.right, nearest, 0, true});
  }
  return result;
}

}  // namespace partwise
