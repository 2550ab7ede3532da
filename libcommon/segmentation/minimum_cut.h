#pragma once

#include <vector>

namespace partwise {

/// Minimises a sum of costs over binary variables x_i: of single ones, and of ordered pairs that differ.
///
/// The minimum is the one with the fewest variables set, so it does not depend on the order of the terms.
class BinaryCut {
 public:
  explicit BinaryCut(int variable_count);

  /// Adds `cost` (any sign) when x_i = 1.
  void add_cost(int i, double cost) { cost_if_set_[i] += cost; }

  /// Adds `cost` >= 0 when x_i = 0 and x_j = 1.
  void add_pair_cost(int i, int j, double cost);

  /// The minimising variables.
  std::vector<bool> minimise() const;

 private:
  struct Pair {
    int i;
    int j;
    double cost;
  };
  std::vector<double> cost_if_set_;
  std::vector<Pair> pairs_;
};

}  // namespace partwise
