#pragma once

#include <vector>

#include "mesh/tri_mesh.h"

namespace partwise {

/// A closed triangulation that can be collapsed vertex by vertex and restored in reverse order.
///
/// It is kept as one cyclic list of neighbours per vertex, counterclockwise: facets are (u, r[i], r[i + 1]).
class RingMesh {
 public:
  using Ring = std::vector<int>;

  /// \pre mesh is closed
  explicit RingMesh(const TriMesh& mesh);

  const Ring& ring(int vertex) const { return rings_[vertex]; }
  bool is_present(int vertex) const { return !rings_[vertex].empty(); }
  int present_count() const { return present_count_; }

  /// The link condition: merging u into its neighbour v keeps a closed triangulation of the same genus.
  bool can_collapse(int u, int v) const;

  /// Merges u into its neighbour v. \pre can_collapse(u, v) \return the ring of u, starting at v: what
  /// restore needs.
  Ring collapse(int u, int v);

  /// Undoes the latest collapse that has not been undone: `ring` is what it returned.
  void restore(int u, const Ring& ring);

 private:
  std::vector<Ring> rings_;
  int present_count_ = 0;
};

}  // namespace partwise
