#include "mesh/vertex_rings.h"

#include <utility>

namespace partwise {

std::vector<bool> within_rings(const Facets& facets, std::vector<bool> vertices, int rings) {
  for (int i = 0; i < rings; ++i) {
    std::vector<bool> wider = vertices;
    for (const Facet& f : facets) {
      if (!vertices[f[0]] && !vertices[f[1]] && !vertices[f[2]]) continue;
      for (const int v : f) wider[v] = true;
    }
    vertices = std::move(wider);
  }
  return vertices;
}

}  // namespace partwise
