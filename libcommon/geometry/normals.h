#pragma once

#include "mesh/tri_mesh.h"

namespace partwise {

/// Twice the area times the unit normal of the triangle (a, b, c).
Vec3 area_vector(const Vec3& a, const Vec3& b, const Vec3& c);

/// Per facet: unit normal; zero for a facet without area.
Points facet_normals(const Points& points, const Facets& facets);

/// Per vertex: unit normal, the facets' normals weighted by the angle at the vertex; zero where they cancel.
Points vertex_normals(const Points& points, const Facets& facets);

/// Per facet: area, in squared units of the model.
std::vector<double> facet_areas(const Points& points, const Facets& facets);

/// Per vertex: area of its 1-ring, in squared units of the model.
std::vector<double> ring_areas(const Points& points, const Facets& facets);

}  // namespace partwise
