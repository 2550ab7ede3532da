#include "segmentation/facet_hierarchy.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "geometry/normals.h"
#include "segmentation/crease_field.h"

namespace partwise {
namespace {

using Level = FacetHierarchy::Level;

constexpr int kRounds = 4;           // of proposals per level
constexpr double kLeastGain = 0.95;  // a level that keeps more of its nodes is the last

/// Lengths per link and areas per node of one level.
struct Measures {
  std::vector<double> length, area;
};

/// Per node its partner, or itself. Two nodes that prefer each other are joined, in a few rounds.
std::vector<int> matched(const Level& level, const Measures& measures) {
  std::vector<int> partner(level.node_count(), -1), choice(level.node_count(), -1);
  auto best_of = [&](int i) {
    int best = -1;
    double highest = -1;
    for (int k = level.first[i]; k < level.first[i + 1]; ++k) {
      const int j = level.neighbour[k];
      if (partner[j] >= 0 || j == i) continue;
      const double rating = measures.length[k] * measures.length[k] / std::max(measures.area[j], 1e-300);
      if (rating > highest || (rating == highest && j < best)) {
        highest = rating;
        best = j;
      }
    }
    return best;
  };
  std::vector<int> open(level.node_count());
  std::iota(open.begin(), open.end(), 0);
  for (int round = 0; round < kRounds && !open.empty(); ++round) {
    for (const int i : open) choice[i] = best_of(i);
    for (const int i : open) {
      if (choice[i] > i && choice[choice[i]] == i) {
        partner[i] = choice[i];
        partner[choice[i]] = i;
      }
    }
    std::erase_if(open, [&](int i) { return partner[i] >= 0 || choice[i] < 0; });
  }
  for (std::size_t i = 0; i < partner.size(); ++i) {
    if (partner[i] < 0) partner[i] = static_cast<int>(i);
  }
  return partner;
}

/// The next level; fills parent and link_above of `level`.
Level joined(Level& level, const std::vector<int>& partner) {
  std::vector<int> first_child;
  level.parent.resize(level.node_count());
  for (int i = 0; i < level.node_count(); ++i) {
    if (partner[i] >= i) first_child.push_back(i);
    level.parent[i] = partner[i] >= i ? static_cast<int>(first_child.size()) - 1 : level.parent[partner[i]];
  }
  level.link_above.assign(level.neighbour.size(), -1);
  Level above;
  std::vector<int> link_to(first_child.size(), -1);  // the link from the node at hand to another
  for (std::size_t i = 0; i < first_child.size(); ++i) {
    const int begin = above.first.empty() ? 0 : static_cast<int>(above.neighbour.size());
    if (above.first.empty()) above.first.push_back(0);
    auto adopt = [&](int child) {
      for (int k = level.first[child]; k < level.first[child + 1]; ++k) {
        const int j = level.parent[level.neighbour[k]];
        if (j == static_cast<int>(i)) continue;
        if (link_to[j] < begin) {
          link_to[j] = static_cast<int>(above.neighbour.size());
          above.neighbour.push_back(j);
        }
        level.link_above[k] = link_to[j];
      }
    };
    adopt(first_child[i]);
    if (partner[first_child[i]] != first_child[i]) adopt(partner[first_child[i]]);
    above.first.push_back(static_cast<int>(above.neighbour.size()));
  }
  return above;
}

std::vector<double> summed(const std::vector<double>& values, const std::vector<int>& target,
                           std::size_t count) {
  std::vector<double> sums(count, 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (target[i] >= 0) sums[target[i]] += values[i];
  }
  return sums;
}

}  // namespace

FacetHierarchy::FacetHierarchy(const TriMesh& mesh, int coarsest) {
  FacetLinks links = facet_links(mesh);
  Measures measures{{}, facet_areas(mesh.points(), mesh.facets())};
  measures.length.reserve(links.edge.size());
  for (const int e : links.edge) measures.length.push_back(edge_length(mesh, e));
  levels_.push_back({std::move(links.first), std::move(links.neighbour), {}, {}});
  while (levels_.back().node_count() > coarsest) {
    Level& level = levels_.back();
    Level above = joined(level, matched(level, measures));
    if (above.node_count() > kLeastGain * level.node_count()) {
      level.parent.clear();
      level.link_above.clear();
      break;
    }
    measures = {summed(measures.length, level.link_above, above.neighbour.size()),
                summed(measures.area, level.parent, above.node_count())};
    levels_.push_back(std::move(above));
  }
}

std::vector<int> FacetHierarchy::nodes_of_facets(int level) const {
  std::vector<int> nodes(levels_.front().node_count());
  std::iota(nodes.begin(), nodes.end(), 0);
  for (int k = 0; k < level; ++k) {
    for (int& node : nodes) node = levels_[k].parent[node];
  }
  return nodes;
}

std::vector<FacetGraph> graphs_of_levels(const FacetHierarchy& hierarchy, FacetGraph facets) {
  std::vector<FacetGraph> graphs;
  graphs.push_back(std::move(facets));
  for (std::size_t k = 0; k + 1 < hierarchy.levels().size(); ++k) {
    const Level &level = hierarchy.levels()[k], &above = hierarchy.levels()[k + 1];
    const FacetGraph& below = graphs.back();
    graphs.push_back({above.first, above.neighbour,
                      summed(below.conductance, level.link_above, above.neighbour.size()),
                      summed(below.cut_cost, level.link_above, above.neighbour.size()),
                      summed(below.size, level.parent, above.node_count())});
  }
  return graphs;
}

}  // namespace partwise
