#pragma once

#include <string>
#include <vector>

#include "mesh/segmentation.h"
#include "segmentation/sketch.h"

namespace partwise {

/// One of the pieces that a part would fall into.
struct ProposedPiece {
  std::string name;                   ///< the part's own for what keeps it, "body 2" and so on for new parts
  std::vector<VertexStroke> strokes;  ///< that make it; of the model's vertices
  Concavity concavity;                ///< as measured, see measure_concavity()
};

/// Where to cut a part that is too concave: a suggestion for a person to judge, no decision.
struct CutProposal {
  int part = 0;
  std::vector<ProposedPiece> pieces;  ///< at least two; the first keeps the part's name
  std::vector<BoundaryCurve> curves;  ///< to cut along: `left` and `right` are pieces, vertices the model's
  std::vector<int> piece_of_facet;    ///< per facet of the model; -1 outside the part
};

/// Per part whose concavity exceeds `tau` where to cut it, if a place is found.
///
/// Looked for by search_cuts(), so that every piece comes below `tau` and, better, half of the part's
/// concavity, with as few new parts as do that; then cut along what the pieces' strokes give on the part
/// alone (see Segmenter), and measured. The largest concavity of every piece is below the part's, and their
/// mean over all vertices, too: a cut that does not reach this is not proposed. Parts keep their boundaries.
/// \param names of all parts, which those of new parts avoid
std::vector<CutProposal> propose_cuts(const TriMesh& mesh, const Segmentation& segmentation,
                                      const std::vector<Concavity>& concavity, double tau);

/// One sentence per part whose concavity exceeds `tau`: where to decompose it further, and along which curves
/// where a proposal says so.
std::vector<std::string> decomposition_hints(const TriMesh& mesh, const Segmentation& segmentation,
                                             const std::vector<Concavity>& concavity, double tau,
                                             const std::vector<CutProposal>& proposals);

}  // namespace partwise
