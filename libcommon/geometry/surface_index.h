#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "mesh/surface_point.h"

namespace partwise {

/// Answer of a spatial query: a point of the surface and how far along or away it is.
struct SurfaceHit {
  SurfacePoint point;
  Vec3 position = Vec3::Zero();
  double distance = 0;  ///< >= 0, in the units of the model
};

/// Closest-point and ray queries on a triangle surface, in double precision.
///
/// Immutable after construction; queries may run concurrently. The indexed facets need not be a manifold.
class SurfaceIndex {
 public:
  /// \pre facets is not empty and names vertices of `points`
  SurfaceIndex(const Points& points, const Facets& facets);
  explicit SurfaceIndex(const TriMesh& mesh);
  ~SurfaceIndex();
  SurfaceIndex(SurfaceIndex&&) noexcept;
  SurfaceIndex& operator=(SurfaceIndex&&) noexcept;

  /// The point of the surface closest to `query`.
  SurfaceHit closest(const Vec3& query) const;

  /// Whether some point of the surface is at most `distance` (>= 0) from `query`; quicker than closest.
  bool has_within(double distance, const Vec3& query) const;

  /// First hit of the ray from `origin` along `direction` (any length > 0), or none.
  std::optional<SurfaceHit> first_hit(const Vec3& origin, const Vec3& direction) const;

  /// All facets hit by the ray, by ascending distance, then facet index.
  std::vector<SurfaceHit> all_hits(const Vec3& origin, const Vec3& direction) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace partwise
