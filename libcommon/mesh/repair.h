#pragma once

#include <optional>

#include "mesh/texture_corners.h"

/// Small repairs of triangle soups, each by itself, on request: nothing is ever repaired silently.
///
/// Vertices and facets that stay keep their order.
namespace partwise {

/// Triangles that need not form a mesh yet. \pre of every function here: facets name vertices of `points`
struct TriangleSoup {
  Points points;
  Facets facets;
  std::optional<TextureCorners> texture{};
};

/// A repaired soup and how many facets or vertices (see each function) the repair concerned.
struct Repaired {
  TriangleSoup soup;
  long count = 0;
};

/// \throws InputError naming the first facet that names a vertex that is not there
void require_indices(const TriangleSoup& soup);

/// Removes facets that name a vertex twice. Counts facets.
Repaired drop_degenerate(TriangleSoup soup);

/// Removes facets with the three vertices of an earlier one. Counts facets.
Repaired drop_duplicates(TriangleSoup soup);

/// Removes vertices without a facet. Counts vertices.
Repaired drop_unused(TriangleSoup soup);

/// Joins each vertex to the first earlier one that stays within `tolerance` times the diagonal of the
/// bounding box, and removes it. Counts vertices. \pre 0 <= tolerance < 1, finite points
Repaired merge_vertices(TriangleSoup soup, double tolerance);

/// Keeps the component (facets joined by common vertices) with the most facets, the first of equals, and its
/// vertices. Counts the components that are removed.
Repaired keep_largest_component(TriangleSoup soup);

/// Turns facets over until neighbours agree: each component as its first facet, or outward (positive volume)
/// when it is closed. Counts facets turned. Edges with more than two facets join nothing.
/// \throws InputError naming a facet of a component that has no orientation (a Moebius strip)
Repaired orient(TriangleSoup soup);

}  // namespace partwise
