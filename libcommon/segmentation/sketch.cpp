#include "segmentation/sketch.h"

#include "error.h"

namespace partwise {

void require_drawn_for(const TriMesh& mesh, const Sketch& sketch) {
  if (!sketch.mesh) return;
  if (sketch.mesh->vertices == mesh.vertex_count() && sketch.mesh->facets == mesh.facet_count()) return;
  throw InputError("the sketch was drawn for a mesh of " + std::to_string(sketch.mesh->vertices) +
                   " vertices and " + std::to_string(sketch.mesh->facets) + " facets, this one has " +
                   std::to_string(mesh.vertex_count()) + " and " + std::to_string(mesh.facet_count()) +
                   "; take the sketch of this mesh");
}

std::vector<std::string> part_names(const Sketch& sketch) {
  if (sketch.parts.empty()) return {"whole"};
  std::vector<std::string> names;
  for (const SketchedPart& part : sketch.parts) names.push_back(part.name);
  return names;
}

}  // namespace partwise
