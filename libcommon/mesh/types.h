#pragma once

#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace partwise {

/// Position or direction in space, in the units of the model.
using Vec3 = Eigen::Vector3d;
using Points = std::vector<Vec3>;

/// Vertex indices of a triangle, counterclockwise seen from outside.
using Facet = std::array<int, 3>;
using Facets = std::vector<Facet>;

}  // namespace partwise
