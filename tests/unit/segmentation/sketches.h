#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mesh/segmentation.h"
#include "segmentation/sketch.h"

/// Sketches for meshes of known shape, and what must hold of every segmentation.
namespace partwise::tests {

/// Index of the vertex nearest to `place`.
int vertex_near(const TriMesh& mesh, const Vec3& place);

/// A part with one stroke through the vertices nearest to `places`.
SketchedPart part_at(const TriMesh& mesh, const std::string& name, const std::vector<Vec3>& places);

/// The mesh with vertices and facets in another, fixed random order; vertex v becomes new_vertex[v].
struct Renumbered {
  TriMesh mesh;
  std::vector<int> new_vertex;
  std::vector<int> new_facet;
};
Renumbered renumbered(const TriMesh& mesh, unsigned seed);

/// An irregular closed mesh without symmetry: a bent, bumpy ball with a waist.
TriMesh irregular_body();

/// Three parts of the irregular body: top, bottom, and a patch on the side; a marker and an anchor.
Sketch body_sketch(const TriMesh& body);

}  // namespace partwise::tests
