#pragma once

#include <memory>

#include "remeshing/compatible_mesh.h"

namespace partwise {

/// The map of a compatible mesh at any point, not only at vertices, and its inverse.
///
/// With charts both ways are one map, exact to rounding: a point goes to the point in the same direction.
/// Without charts a point goes to the closest point of the other surface, the source having the compatible
/// mesh's shape: near, but not one-to-one. May be used concurrently.
class TwoWayMap {
 public:
  /// \pre `mesh` outlives the map
  explicit TwoWayMap(const CompatibleMesh& mesh);
  ~TwoWayMap();
  TwoWayMap(TwoWayMap&&) noexcept;
  TwoWayMap& operator=(TwoWayMap&&) noexcept;

  bool one_to_one() const;

  SurfacePoint to_target(const SurfacePoint& on_source) const;
  SurfacePoint to_source(const SurfacePoint& on_target) const;

  /// The same at a vertex, as the compatible mesh has it.
  SurfacePoint vertex_to_target(int source_vertex) const;
  SurfacePoint vertex_to_source(int target_vertex) const;

 private:
  struct Sides;
  std::unique_ptr<Sides> sides_;
};

}  // namespace partwise
