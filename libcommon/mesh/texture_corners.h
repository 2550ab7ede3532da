#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

#include "mesh/types.h"

namespace partwise {

/// Texture coordinates at the corners of facets, so that neighbours may differ: at a seam.
struct TextureCorners {
  std::vector<std::array<double, 6>> places;  ///< per facet: u, v of its three corners, v upward
  std::vector<int> images;                    ///< per facet: number of its image; empty: one for all

  Eigen::Vector2d place(int facet, int corner) const {
    return {places[facet][2 * corner], places[facet][2 * corner + 1]};
  }
};

/// Texture coordinates of one corner in two facets that differ by more are a seam: far below a pixel, above
/// what floats and interpolation leave.
constexpr double kTextureJump = 1e-6;

/// A mesh whose vertices have one place in the texture each, as graphics hardware and OBJ's `vt` want it.
struct SeamVertices {
  std::vector<int> origins;             ///< per vertex: the mesh's own. Vertex v < vertex_count is v itself
  std::vector<Eigen::Vector2d> places;  ///< per vertex; of vertices without facets (0, 0)
  Facets facets;                        ///< in the order of the mesh
};

/// Doubles the vertices at seams: each keeps its number for the place that its first facet has there, further
/// places get new vertices behind all others.
/// \pre one row of places per facet, whose vertices are below vertex_count
SeamVertices split_at_seams(int vertex_count, const Facets& facets, const TextureCorners& texture);

}  // namespace partwise
