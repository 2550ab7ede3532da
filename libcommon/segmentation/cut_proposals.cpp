#include "segmentation/cut_proposals.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <sstream>
#include <utility>

#include "error.h"
#include "mesh/submesh.h"
#include "segmentation/cut_search.h"
#include "segmentation/segmenter.h"

namespace partwise {
namespace {

constexpr int kPatches = 1600;  // that a part is looked at in
constexpr int kMostPieces = 8;  // cut off one part
constexpr double kGoal = 0.5;   // of the part's concavity
constexpr double kClearance =
    0.25;  // of a piece's extent beyond the cut, where its strokes stay away from it
constexpr double kLeastShare = 0.1;  // of a piece's area, that a piece split from it must have
constexpr double kScrap = 0.05;      // of the part's area, that a piece must have to stand for itself
constexpr double kHardly = 1.1;      // times its depth before, that a piece may get by joining a scrap
constexpr int kStrokes = 8;          // for a piece, at most

/// Per piece the radius of a circle as long as its cuts; for what is left of the part, as its neighbours'
/// shortest.
std::vector<double> reaches_of(const PatchGraph& graph, const std::vector<int>& piece_of, int count) {
  std::vector<double> lengths(count, 0.0);
  for (int i = 0; i < graph.count(); ++i) {
    for (int k = graph.first[i]; k < graph.first[i + 1]; ++k) {
      if (piece_of[graph.neighbour[k]] != piece_of[i]) lengths[piece_of[i]] += graph.border[k];
    }
  }
  lengths[0] = *std::min_element(lengths.begin() + 1, lengths.end());
  for (double& length : lengths) length /= 2 * std::numbers::pi;
  return lengths;
}

/// Per patch: the way to the nearest patch of another piece.
std::vector<double> ways_from_cuts(const PatchGraph& graph, const std::vector<int>& piece_of) {
  std::vector<int> beside;
  for (int i = 0; i < graph.count(); ++i) {
    const auto begin = graph.neighbour.begin() + graph.first[i];
    const auto end = graph.neighbour.begin() + graph.first[i + 1];
    if (std::any_of(begin, end, [&](int j) { return piece_of[j] != piece_of[i]; })) beside.push_back(i);
  }
  return patch_ways(graph, beside, std::vector<bool>(graph.count(), true)).distance;
}

/// The patch of `inside` that is farthest from those on the ways' start: out of their reach, of these the one
/// with the largest `away`, before the end of the longest way. -1 when none is farther than `reach`.
int next_end(const PatchWays& ways, const std::vector<bool>& inside, const std::vector<double>& away,
             double reach) {
  int best = -1;
  const auto rank = [&](int i) { return std::pair(ways.distance[i], away[i]); };
  for (int i = 0; i < static_cast<int>(inside.size()); ++i) {
    if (inside[i] && ways.distance[i] > reach && (best < 0 || rank(i) > rank(best))) best = i;
  }
  return best;
}

/// Strokes through a piece, each to the place farthest from those before, until all are within `reach`.
std::vector<VertexStroke> strokes_for(const PatchGraph& graph, const std::vector<bool>& inside,
                                      const std::vector<double>& away, double reach) {
  std::vector<VertexStroke> strokes;
  std::vector<int> reached;
  for (int s = 0; s < kStrokes; ++s) {
    const PatchWays ways = patch_ways(graph, reached, inside);
    const int end = next_end(ways, inside, away, reach);
    if (end < 0) break;
    VertexStroke stroke;
    for (int i = end; i >= 0; i = ways.previous[i]) {
      reached.push_back(i);
      stroke.vertices.push_back(graph.vertex[i]);
    }
    strokes.push_back(std::move(stroke));
  }
  // A place that another stroke runs through needs no stroke of its own.
  for (std::size_t s = strokes.size(); s-- > 0;) {
    const int place = strokes[s].vertices.front();
    const bool is_covered = std::any_of(strokes.begin(), strokes.end(), [&](const VertexStroke& other) {
      return &other != &strokes[s] &&
             std::find(other.vertices.begin(), other.vertices.end(), place) != other.vertices.end();
    });
    if (strokes[s].vertices.size() == 1 && is_covered)
      strokes.erase(strokes.begin() + static_cast<std::ptrdiff_t>(s));
  }
  return strokes;
}

/// Per patch whether it is so far from the cuts that a stroke may run there.
std::vector<bool> clear_of_cuts(const PatchGraph& graph, const std::vector<int>& piece_of, int count,
                                const std::vector<double>& away) {
  const std::vector<double> reaches = reaches_of(graph, piece_of, count);
  std::vector<double> extent(count, 0.0);
  for (int i = 0; i < graph.count(); ++i) {
    extent[piece_of[i]] = std::max(extent[piece_of[i]], away[i]);
  }
  std::vector<bool> is_clear(graph.count());
  for (int i = 0; i < graph.count(); ++i) {
    is_clear[i] = away[i] >= std::min(kClearance * extent[piece_of[i]], reaches[piece_of[i]] / 2);
  }
  return is_clear;
}

/// Makes pieces of their own of what hangs together only beside the cuts, as two legs at their roots: strokes
/// could not hold that. \return the number of pieces
int split_loose(const PatchGraph& graph, std::vector<int>& piece_of, int count) {
  const std::vector<bool> is_clear = clear_of_cuts(graph, piece_of, count, ways_from_cuts(graph, piece_of));
  const int cut_off = count;
  for (int piece = 0; piece < cut_off; ++piece) {
    std::vector<bool> inside(graph.count(), false), clear(graph.count(), false);
    double area = 0;
    for (int i = 0; i < graph.count(); ++i) {
      inside[i] = piece_of[i] == piece;
      clear[i] = inside[i] && is_clear[i];
      if (inside[i]) area += graph.area[i];
    }
    const std::vector<std::vector<int>> groups = connected_groups(graph, clear);
    std::vector<int> starts, number(graph.count(), piece);
    for (std::size_t g = 0; g < groups.size(); ++g) {
      double group_area = 0;
      for (const int i : groups[g]) group_area += graph.area[i];
      if (g > 0 && group_area < kLeastShare * area) continue;
      for (const int i : groups[g]) number[i] = g == 0 ? piece : count;
      starts.insert(starts.end(), groups[g].begin(), groups[g].end());
      if (g > 0) ++count;
    }
    const PatchWays ways = patch_ways(graph, starts, inside);
    for (const int i : ways.order) {
      if (ways.previous[i] >= 0) number[i] = number[ways.previous[i]];
      piece_of[i] = number[i];
    }
  }
  return count;
}

std::vector<int> patches_of(const std::vector<int>& piece_of, int piece) {
  std::vector<int> patches;
  for (int i = 0; i < static_cast<int>(piece_of.size()); ++i) {
    if (piece_of[i] == piece) patches.push_back(i);
  }
  return patches;
}

/// The other piece that shares most boundary with one, or -1.
int closest_neighbour(const PatchGraph& graph, const std::vector<int>& piece_of, int piece, int count) {
  std::vector<double> shared(count, 0.0);
  for (const int i : patches_of(piece_of, piece)) {
    for (int k = graph.first[i]; k < graph.first[i + 1]; ++k) {
      const int other = piece_of[graph.neighbour[k]];
      if (other != piece) shared[other] += graph.border[k];
    }
  }
  int most = -1;
  for (int other = 0; other < count; ++other) {
    if (shared[other] > 0 && (most < 0 || shared[other] > shared[most])) most = other;
  }
  return most;
}

/// Joins scraps that the cuts left over with a neighbour that hardly gets deeper by it. \return as
/// split_loose
int join_scraps(const PatchGraph& graph, std::vector<int>& piece_of, int count, double goal) {
  const double whole = std::accumulate(graph.area.begin(), graph.area.end(), 0.0);
  for (int piece = count - 1; piece > 0; --piece) {
    std::vector<int> patches = patches_of(piece_of, piece);
    double area = 0;
    for (const int i : patches) area += graph.area[i];
    const int other = closest_neighbour(graph, piece_of, piece, count);
    if (area > kScrap * whole || other < 0) continue;
    const std::vector<int> beside = patches_of(piece_of, other);
    const double before = largest_depth(graph, beside);
    patches.insert(patches.end(), beside.begin(), beside.end());
    if (largest_depth(graph, patches) > std::max(goal, kHardly * before)) continue;
    for (const int i : patches) piece_of[i] = other;
    for (int& number : piece_of) number -= number > piece ? 1 : 0;
    --count;
  }
  return count;
}

/// Strokes for all pieces; vertices are those of the part's surface.
std::vector<std::vector<VertexStroke>> strokes_of(const PatchGraph& graph, const std::vector<int>& piece_of,
                                                  int count) {
  const std::vector<double> away = ways_from_cuts(graph, piece_of);
  const std::vector<bool> is_clear = clear_of_cuts(graph, piece_of, count, away);
  const std::vector<double> reaches = reaches_of(graph, piece_of, count);
  std::vector<std::vector<VertexStroke>> strokes;
  for (int piece = 0; piece < count; ++piece) {
    std::vector<bool> may_pass = is_clear;
    for (int i = 0; i < graph.count(); ++i) {
      if (piece_of[i] != piece) may_pass[i] = false;
    }
    strokes.push_back(strokes_for(graph, may_pass, away, reaches[piece]));
  }
  return strokes;
}

Sketch sketch_of(const std::vector<std::vector<VertexStroke>>& strokes) {
  Sketch sketch;
  for (std::size_t k = 0; k < strokes.size(); ++k) {
    sketch.parts.push_back({std::to_string(k), {strokes[k].begin(), strokes[k].end()}});
  }
  return sketch;
}

/// Every piece less concave than the part, and all of them together on average.
bool helps(const SegmentedMesh& cut, double diagonal, const Concavity& before) {
  const double scale = cut.model.mesh.diagonal() / diagonal;
  double sum = 0, count = 0;
  std::vector<double> facets(cut.model.concavity.size(), 0.0);
  for (const int label : cut.model.segmentation.labels) ++facets[label];
  for (std::size_t k = 0; k < facets.size(); ++k) {
    if (scale * cut.model.concavity[k].largest >= before.largest) return false;
    sum += facets[k] * scale * cut.model.concavity[k].mean;
    count += facets[k];
  }
  return sum / count < before.mean;
}

CutProposal to_model(const TriMesh& mesh, int part, const Submesh& surface, const SegmentedMesh& cut,
                     const Sketch& strokes) {
  CutProposal proposal{part, {}, {}, std::vector<int>(mesh.facet_count(), -1)};
  const double scale = surface.mesh.diagonal() / mesh.diagonal();
  for (std::size_t k = 0; k < strokes.parts.size(); ++k) {
    ProposedPiece piece;
    for (const Stroke& stroke : strokes.parts[k].strokes) {
      piece.strokes.push_back(std::get<VertexStroke>(stroke));
      for (int& v : piece.strokes.back().vertices) v = surface.model_vertex[v];
    }
    const Concavity& measured = cut.model.concavity[k];
    piece.concavity = {scale * measured.largest, scale * measured.mean,
                       measured.vertex < 0 ? -1 : surface.model_vertex[measured.vertex]};
    proposal.pieces.push_back(std::move(piece));
  }
  for (BoundaryCurve curve : cut.model.segmentation.curves) {
    if (curve.right == kOutside) continue;  // the part's boundary, which stays
    for (int& v : curve.vertices) v = surface.model_vertex[v];
    proposal.curves.push_back(std::move(curve));
  }
  for (std::size_t f = 0; f < surface.model_facet.size(); ++f) {
    proposal.piece_of_facet[surface.model_facet[f]] = cut.model.segmentation.labels[f];
  }
  return proposal;
}

/// Of one part; none when no cut helps.
std::optional<CutProposal> propose_cut(const TriMesh& mesh, const std::vector<int>& labels, int part,
                                       const Concavity& before, double tau) {
  const Submesh surface = extract_submesh(mesh, facets_labelled(labels, part));
  const PatchGraph graph = patch_graph(surface.mesh, kPatches);
  const double goal = std::min(tau, kGoal * before.largest) * mesh.diagonal();
  std::optional<Segmenter> segmenter;
  // Fewer pieces are asked for while those found do not help.
  for (int most = kMostPieces; most > 0;) {
    std::vector<int> piece_of = search_cuts(graph, goal, most);
    const int found = 1 + *std::max_element(piece_of.begin(), piece_of.end());
    if (found == 1) return std::nullopt;
    const int count = join_scraps(graph, piece_of, split_loose(graph, piece_of, found), goal);
    if (count == 1) return std::nullopt;
    const Sketch strokes = sketch_of(strokes_of(graph, piece_of, count));
    if (!segmenter) segmenter.emplace(surface.mesh);
    try {
      const SegmentedMesh cut = segmenter->segment(strokes);
      if (helps(cut, mesh.diagonal(), before)) return to_model(mesh, part, surface, cut, strokes);
    } catch (const Error&) {
      // Pieces too small or too close for their strokes.
    }
    most = std::min(most, found - 1) - 1;
  }
  return std::nullopt;
}

/// "through vertices 3 and 17 (0.2 long)": opposite ends of a curve, and its length over the diagonal.
void describe(const TriMesh& mesh, const BoundaryCurve& curve, std::ostream& text) {
  text << "through vertices " << curve.vertices.front() << " and "
       << curve.vertices[curve.vertices.size() / 2] << " (" << curve.length / mesh.diagonal() << " long)";
}

/// Which pieces, along which curves, and how concave they then are.
void describe(const TriMesh& mesh, const CutProposal& proposal, std::ostream& text) {
  double largest = 0;
  for (const ProposedPiece& piece : proposal.pieces) largest = std::max(largest, piece.concavity.largest);
  text << "; suggestion: cut it into " << proposal.pieces.size() << " along "
       << (proposal.curves.size() == 1 ? "the curve " : "the curves ");
  for (std::size_t k = 0; k < proposal.curves.size(); ++k) {
    if (k > 0) text << (k + 1 == proposal.curves.size() ? " and " : ", ");
    describe(mesh, proposal.curves[k], text);
  }
  text << ", then none lies more than " << largest << " inside its hull";
}

/// "body", "body 2", "body 3": none that another part has.
void name_pieces(CutProposal& proposal, std::vector<std::string>& names) {
  const std::string name = names[proposal.part];
  int number = 2;
  for (std::size_t k = 0; k < proposal.pieces.size(); ++k) {
    std::string own = name;
    while (k > 0 && std::find(names.begin(), names.end(), own) != names.end()) {
      own = name + " " + std::to_string(number++);
    }
    proposal.pieces[k].name = own;
    if (k > 0) names.push_back(std::move(own));
  }
}

}  // namespace

std::vector<CutProposal> propose_cuts(const TriMesh& mesh, const Segmentation& segmentation,
                                      const std::vector<Concavity>& concavity, double tau) {
  std::vector<CutProposal> proposals;
  std::vector<std::string> names = segmentation.names;
  for (int part = 0; part < segmentation.part_count(); ++part) {
    if (concavity[part].largest <= tau) continue;
    auto proposal = propose_cut(mesh, segmentation.labels, part, concavity[part], tau);
    if (!proposal) continue;
    name_pieces(*proposal, names);
    proposals.push_back(std::move(*proposal));
  }
  return proposals;
}

std::vector<std::string> decomposition_hints(const TriMesh& mesh, const Segmentation& segmentation,
                                             const std::vector<Concavity>& concavity, double tau,
                                             const std::vector<CutProposal>& proposals) {
  std::vector<std::string> hints;
  for (int part = 0; part < segmentation.part_count(); ++part) {
    if (concavity[part].largest <= tau) continue;
    std::ostringstream text;
    text.precision(2);
    text << "part '" << segmentation.names[part] << "': decompose further near vertex "
         << concavity[part].vertex << ", which lies " << concavity[part].largest
         << " of the model's diagonal inside the part's convex hull (tau is " << tau << ")";
    const auto proposal = std::find_if(proposals.begin(), proposals.end(),
                                       [&](const CutProposal& p) { return p.part == part; });
    if (proposal != proposals.end()) describe(mesh, *proposal, text);
    hints.push_back(text.str());
  }
  return hints;
}

}  // namespace partwise
