#pragma once

#include <memory>
#include <vector>

#include "energy/energy_term.h"

namespace partwise {

/// Minimises a weighted sum of energy terms over vertex positions; one sparse factorisation serves the three
/// coordinates.
///
/// \code
/// LeastSquares system(vertex_count);
/// for (...) {
///   system.clear();
///   system.add(weights.laplacian, laplacian_term(part_weights));
///   system.add(weights.global, global_constraint_term(vertex_count, constraints));
///   points = system.minimise();
/// }
/// \endcode
/// The pattern of non-zeros is analysed when it first occurs or changes; new weights only refactor.
class LeastSquares {
 public:
  /// `fixed` vertices are no unknowns: they are exactly at their targets (their weights do not matter).
  explicit LeastSquares(int vertex_count, const std::vector<VertexTarget>& fixed = {});
  ~LeastSquares();
  LeastSquares(LeastSquares&&) noexcept;
  LeastSquares& operator=(LeastSquares&&) noexcept;

  /// Forgets the terms, keeps the analysis.
  void clear();

  /// \pre weight >= 0, the term is about vertex_count vertices
  void add(double weight, const EnergyTerm& term);

  /// The positions of least energy, one per vertex.
  /// \throws ComputationError when the terms do not determine all positions.
  Points minimise();

 private:
  struct System;
  std::unique_ptr<System> system_;
};

}  // namespace partwise
