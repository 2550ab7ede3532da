#pragma once

#include "mesh/types.h"

namespace partwise {

/// A smooth surface that every ray from the origin meets once: a domain to move a mesh's vertices over.
class StarSurface {
 public:
  struct Place {
    Vec3 position = Vec3::Zero();
    Vec3 normal = Vec3::Zero();  ///< unit, outward
    double height = 0;           ///< distance of the tangent plane to the origin
  };

  virtual ~StarSurface() = default;

  /// Where a direction (any length > 0) meets the surface.
  virtual Place project(const Vec3& direction) const = 0;
};

class UnitSphere : public StarSurface {
 public:
  Place project(const Vec3& direction) const override {
    const Vec3 unit = direction.stableNormalized();
    return {unit, unit, 1};
  }
};

}  // namespace partwise
