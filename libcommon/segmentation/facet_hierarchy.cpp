#include "segmentation/facet_hierarchy.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

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
    tbb::parallel_for(std::size_t{0}, open.size(),
                      [&](std::size_t k) { choice[open[k]] = best_of(open[k]); });
    tbb::parallel_for(std::size_t{0}, open.size(), [&](std::size_t k) {  // a node is in one pair at most
      const int i = open[k];
      if (choice[i] > i && choice[choice[i]] == i) {
        partner[i] = choice[i];
        partner[choice[i]] = i;
      }
    });
    std::erase_if(open, [&](int i) { return partner[i] >= 0 || choice[i] < 0; });
  }
  for (std::size_t i = 0; i < partner.size(); ++i) {
    if (partner[i] < 0) partner[i] = static_cast<int>(i);
  }
  return partner;
}

/// The next level; fills parent and link_above of `level`. Links of a node come in the order in which its
/// children's lead there first.
Level joined(Level& level, const std::vector<int>& partner) {
  std::vector<int> first_child;
  level.parent.resize(level.node_count());
  std::vector<int> room{0};  // where the links of each new node could begin if all children's stayed apart
  for (int i = 0; i < level.node_count(); ++i) {
    if (partner[i] >= i) {
      level.parent[i] = static_cast<int>(first_child.size());
      first_child.push_back(i);
      const int j = partner[i];
      room.push_back(room.back() + level.first[i + 1] - level.first[i] +
                     (j > i ? level.first[j + 1] - level.first[j] : 0));
    } else {
      level.parent[i] = level.parent[partner[i]];
    }
  }
  const auto for_children = [&](std::size_t node, const auto& visit) {
    const int i = first_child[node];
    visit(i);
    if (partner[i] > i) visit(partner[i]);
  };
  // Nodes have few links, so that a search along them finds those met before.
  level.link_above.assign(level.neighbour.size(), -1);
  std::vector<int> met(room.back());
  Level above;
  above.first.resize(first_child.size() + 1);
  tbb::parallel_for(std::size_t{0}, first_child.size(), [&](std::size_t node) {
    const auto begin = met.begin() + room[node];
    auto end = begin;
    for_children(node, [&](int child) {
      for (int k = level.first[child]; k < level.first[child + 1]; ++k) {
        const int j = level.parent[level.neighbour[k]];
        if (j == static_cast<int>(node)) continue;
        const auto link = std::find(begin, end, j);
        if (link == end) *end++ = j;
        level.link_above[k] = static_cast<int>(link - begin);
      }
    });
    above.first[node + 1] = static_cast<int>(end - begin);
  });
  std::partial_sum(above.first.begin(), above.first.end(), above.first.begin());
  above.neighbour.resize(above.first.back());
  tbb::parallel_for(std::size_t{0}, first_child.size(), [&](std::size_t node) {
    const int begin = above.first[node], count = above.first[node + 1] - begin;
    std::copy_n(met.begin() + room[node], count, above.neighbour.begin() + begin);
    for_children(node, [&](int child) {
      for (int k = level.first[child]; k < level.first[child + 1]; ++k) {
        if (level.link_above[k] >= 0) level.link_above[k] += begin;
      }
    });
  });
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
  Measures measures{std::vector<double>(links.edge.size()), facet_areas(mesh.points(), mesh.facets())};
  tbb::parallel_for(std::size_t{0}, links.edge.size(),
                    [&](std::size_t k) { measures.length[k] = edge_length(mesh, links.edge[k]); });
  levels_.push_back({std::move(links.first), std::move(links.neighbour), {}, {}});
  while (levels_.back().node_count() > coarsest) {
    Level& level = levels_.back();
    Level above = joined(level, matched(level, measures));
    if (above.node_count() > kLeastGain * level.node_count()) {
      level.parent.clear();
      level.link_above.clear();
      break;
    }
    Measures next;
    tbb::parallel_invoke(
        [&] { next.length = summed(measures.length, level.link_above, above.neighbour.size()); },
        [&] { next.area = summed(measures.area, level.parent, above.node_count()); });
    measures = std::move(next);
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
    FacetGraph next{above.first, above.neighbour, {}, {}, {}};
    tbb::parallel_invoke(
        [&] { next.conductance = summed(below.conductance, level.link_above, above.neighbour.size()); },
        [&] { next.cut_cost = summed(below.cut_cost, level.link_above, above.neighbour.size()); },
        [&] { next.size = summed(below.size, level.parent, above.node_count()); });
    graphs.push_back(std::move(next));
  }
  return graphs;
}

}  // namespace partwise
