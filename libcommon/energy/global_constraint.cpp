#include "energy/global_constraint.h"

namespace partwise {

EnergyTerm global_constraint_term(int vertex_count, const std::vector<VertexTarget>& constraints) {
  return point_term(vertex_count, constraints);
}

}  // namespace partwise
