#include "energy/critical_constraint.h"

namespace partwise {

EnergyTerm critical_constraint_term(int vertex_count, const std::vector<VertexTarget>& critical) {
  return point_term(vertex_count, critical);
}

}  // namespace partwise
