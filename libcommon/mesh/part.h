#pragma once

#include <vector>

#include "mesh/segmentation.h"

namespace partwise {

/// One part as a closed mesh of its own: the part's facets, and a cap over each of its boundary loops.
///
/// A cap is a fan of facets around a new vertex, the loop's centroid. Local vertices are the part's vertices
/// by ascending index in the model, then one vertex per loop; local facets the part's facets by ascending
/// index, then the caps.
struct Part {
  int index = 0;                        ///< which part of the model; -1 for a piece of several
  TriMesh mesh;                         ///< closed
  std::vector<int> model_vertex;        ///< per local vertex: vertex of the model, or -1 for a cap's centre
  std::vector<int> model_facet;         ///< per local facet: facet of the model, or -1 in a cap
  std::vector<std::vector<int>> loops;  ///< boundary loops as local vertices, the part on the left
  std::vector<int> cap_vertices;        ///< per loop: the local vertex at its cap's centre

  bool is_cap_vertex(int local) const { return model_vertex[local] < 0; }
  bool is_cap_facet(int local) const { return model_facet[local] < 0; }

  /// Local number of a vertex of the model, -1 when it is not in the part.
  int local_vertex(int of_model) const;

  /// Connected, and without handles: the capped part is a sphere.
  bool is_sphere() const;
};

/// The same for any set of facets: `inside` has one entry per facet of `mesh`.
/// \pre some facet is inside, and they touch along edges only
Part extract_piece(const TriMesh& mesh, const std::vector<bool>& inside);

/// \pre 0 <= part < model.segmentation.part_count(), the segmentation is valid (see trace_boundaries)
Part extract_part(const SegmentedModel& model, int part);

}  // namespace partwise
