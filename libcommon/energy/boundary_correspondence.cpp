#include "energy/boundary_correspondence.h"

namespace partwise {

EnergyTerm boundary_correspondence_term(int vertex_count, const std::vector<VertexTarget>& boundary) {
  return point_term(vertex_count, boundary);
}

}  // namespace partwise
