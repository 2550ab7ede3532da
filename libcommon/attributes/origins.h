#pragma once

#include <vector>

#include "mesh/surface_point.h"

namespace partwise {

/// Where the points of a model that receives attributes come from on the model that gives them.
struct Origins {
  std::vector<SurfacePoint> vertices;             ///< per vertex
  std::vector<std::vector<SurfacePoint>> facets;  ///< per facet: some points inside, for equal shares of area
};

}  // namespace partwise
