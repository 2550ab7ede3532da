#pragma once

#include "mesh/texture_corners.h"
#include "mesh/tri_mesh.h"

/// Meshes of known shape for the tests; all are oriented outward and, but for two_spheres, centred at the
/// origin.
namespace partwise::tests {

/// Regular tetrahedron with its corners on the unit sphere: 4 vertices, 4 facets.
TriMesh tetrahedron();

/// Surface of [-1, 1]^3, every side a grid of n x n squares cut in two: 12 n^2 facets.
TriMesh cube(int n);

/// Unit sphere from a subdivided octahedron: 8 n^2 facets.
TriMesh sphere(int n);

/// The sphere with bumps along the six axes, each `height` high: r = 1 + height * sum exp(-(angle / 0.25)^2).
TriMesh bumpy_sphere(int n, double height);

/// The sphere with 60 narrow bumps spread evenly over it: r = 1 + height * sum exp(-(angle / 0.1)^2). No
/// vertex of a cube knows of them, as in [Wu11] Fig. 11.
TriMesh many_bumps(int n, double height);

/// The directions of their tips, unit.
Points bump_directions();

/// Torus around the z axis: 2 * around * across facets.
TriMesh torus(double major_radius, double minor_radius, int around, int across);

/// sphere(n), and behind it in all lists its copy around (5, 0, 0): two components.
TriMesh two_spheres(int n);

/// Upper half of sphere(n): one boundary loop. \pre n is even
TriMesh hemisphere(int n);

/// Flat n x n grid over [-1, 1]^2 at z = 0, seen from +z: one boundary loop, 2 n^2 facets.
TriMesh grid(int n);

/// Two half-balls of radius 1 at z = -length / 2 and length / 2 joined by a tube, slightly thinned at z = 0.
TriMesh capsule(double length, int around, int along);

/// Cuts every `step`-th facet in three by a vertex over the middle of its first edge, `height` of the edge's
/// length off it: every such facet leaves a sliver with two angles of about 2 height and one near 180
/// degrees.
TriMesh with_flat_slivers(const TriMesh& mesh, int step, double height);

/// Cuts every `step`-th edge `fraction` of its length from one end: the two facets at the short piece are
/// slivers with one angle of about `fraction`.
TriMesh with_needles(const TriMesh& mesh, int step, double fraction);

/// The mesh with an opening in the facet that lies farthest in a direction, `size` times as large as the
/// facet: one boundary loop of 3 vertices.
TriMesh with_opening(const TriMesh& mesh, const Vec3& direction, double size);

/// u goes around the z axis once, from 0, and jumps at the seam in the half-plane y = 0, x < 0; v is z.
TextureCorners cylindrical_texture(const TriMesh& mesh);

}  // namespace partwise::tests
