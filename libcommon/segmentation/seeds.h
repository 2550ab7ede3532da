#pragma once

#include <string>
#include <vector>

#include "mesh/tri_mesh.h"

namespace partwise {

/// No part fixed (yet).
inline constexpr int kUnseeded = -1;

/// A stroke as vertices of the mesh: sorted, each once, so that order and repetition mean nothing.
struct SeedStroke {
  int part = 0;   ///< index of the part
  int index = 0;  ///< which stroke of that part
  std::vector<int> vertices;

  bool operator==(const SeedStroke&) const = default;
};

/// What the strokes fix before any boundary is sought.
struct Seeds {
  std::vector<int>
      vertex_part;              ///< per vertex: the part whose strokes touch it; kUnseeded if none or several
  std::vector<int> facet_part;  ///< per facet: the part whose strokes touch its vertices; likewise
};

/// Collects the strokes of all parts.
///
/// \pre mesh vertices in range
/// \throws InputError when a part has no stroke, a stroke leaves no facet to its part because other parts'
///         strokes touch all of them, a part's strokes lie on several components of the mesh, or a component
///         has no stroke.
Seeds collect_seeds(const TriMesh& mesh, const std::vector<std::string>& names,
                    const std::vector<SeedStroke>& strokes);

/// The same when the components are known. \param components see facet_components()
Seeds collect_seeds(const TriMesh& mesh, const std::vector<int>& components,
                    const std::vector<std::string>& names, const std::vector<SeedStroke>& strokes);

/// Per facet: the number of its connected component, counted from facet 0.
std::vector<int> facet_components(const TriMesh& mesh);

}  // namespace partwise
