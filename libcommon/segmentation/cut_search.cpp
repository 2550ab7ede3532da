#include "segmentation/cut_search.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "error.h"
#include "geometry/convex_hull.h"

namespace partwise {
namespace {

constexpr int kSpread = 16;          // patches that stand for the whole when ends are sought
constexpr std::size_t kEnds = 16;    // ends looked at
constexpr double kLeastArea = 0.02;  // of the part, that a piece must have
constexpr double kMostArea = 0.75;   // of what it is cut from, that a piece may have
constexpr double kRoot = 1.5;        // times the shortest boundary for the area: still a neck, at its far end
constexpr double kLeastGain = 0.02;  // of the part's depth, that a cut must take away

/// How a set of patches lies below its hull.
struct Depth {
  double largest = 0;
  double total = 0;  // times area
  int deepest = -1;
};

Depth depth_of(const PatchGraph& graph, const std::vector<int>& patches) {
  Points points;
  for (const int i : patches) points.push_back(graph.centre[i]);
  std::vector<double> distances;
  try {
    distances = distances_to_hull(convex_hull(points), points);
  } catch (const InputError&) {
    return {};  // flat
  }
  Depth depth;
  for (std::size_t k = 0; k < patches.size(); ++k) {
    depth.total += distances[k] * graph.area[patches[k]];
    if (distances[k] <= depth.largest) continue;
    depth.largest = distances[k];
    depth.deepest = patches[k];
  }
  return depth;
}

double area_of(const PatchGraph& graph, const std::vector<int>& patches) {
  return std::accumulate(patches.begin(), patches.end(), 0.0,
                         [&](double sum, int i) { return sum + graph.area[i]; });
}

/// A piece that might be cut off what is left of the part.
struct Candidate {
  std::vector<int> piece, left;
  Depth piece_depth, left_depth;
  double score = 0;
};

/// A piece, and how deep it lies.
struct Measured {
  std::vector<int> patches;
  Depth depth;
};

class CutSearch {
 public:
  CutSearch(const PatchGraph& graph, double goal, int most) : graph_(graph), goal_(goal), most_(most) {
    std::vector<int> all(graph.count());
    std::iota(all.begin(), all.end(), 0);
    area_ = area_of(graph, all);
    const Depth depth = depth_of(graph, all);
    total_ = depth.total;
    pieces_.push_back({std::move(all), depth});
    find_ends();
  }

  std::vector<int> pieces() {
    std::vector<bool> is_final(1, false);  // no cut of it gains anything
    while (static_cast<int>(pieces_.size()) <= most_) {
      std::size_t deepest = pieces_.size();
      for (std::size_t k = 0; k < pieces_.size(); ++k) {
        if (is_final[k] || pieces_[k].depth.largest <= goal_) continue;
        if (deepest == pieces_.size() || pieces_[k].depth.largest > pieces_[deepest].depth.largest)
          deepest = k;
      }
      if (deepest == pieces_.size()) break;
      std::optional<Candidate> best = best_cut(pieces_[deepest]);
      if (!best) {
        is_final[deepest] = true;
        continue;
      }
      pieces_[deepest] = {std::move(best->left), best->left_depth};
      pieces_.push_back({std::move(best->piece), best->piece_depth});
      is_final.push_back(false);
    }
    join_needless();
    return numbered();
  }

 private:
  std::vector<bool> mask(const std::vector<int>& patches) const {
    std::vector<bool> inside(graph_.count(), false);
    for (const int i : patches) inside[i] = true;
    return inside;
  }

  void find_ends();
  std::optional<Candidate> best_cut(const Measured& from) const;
  std::vector<Candidate> cuts_for(int end, const Measured& from, const std::vector<bool>& inside) const;
  std::optional<Candidate> beyond(const PatchWays& ways, std::size_t size, double length,
                                  const Measured& from, const std::vector<bool>& inside) const;
  bool join_one();
  void join_needless();
  std::vector<int> numbered() const;

  const PatchGraph& graph_;
  double goal_;
  int most_;
  double area_ = 0, total_ = 0;
  std::vector<int> ends_;
  std::vector<Measured> pieces_;
};

/// Where the sum of squared ways to patches spread over the part has local maxima, spread themselves.
void CutSearch::find_ends() {
  const std::vector<bool> everywhere(graph_.count(), true);
  std::vector<int> starts{patch_ways(graph_, {0}, everywhere).order.back()};
  std::vector<double> remoteness(graph_.count(), 0.0);
  for (int i = 0; i < std::min(kSpread, graph_.count()); ++i) {
    const PatchWays ways = patch_ways(graph_, {starts.back()}, everywhere);
    for (const int p : ways.order) remoteness[p] += ways.distance[p] * ways.distance[p];
    starts.push_back(patch_ways(graph_, starts, everywhere).order.back());
  }
  std::vector<int> maxima;
  for (int i = 0; i < graph_.count(); ++i) {
    const auto begin = graph_.neighbour.begin() + graph_.first[i];
    const auto end = graph_.neighbour.begin() + graph_.first[i + 1];
    if (std::none_of(begin, end, [&](int j) { return remoteness[j] > remoteness[i]; })) maxima.push_back(i);
  }
  const int core =
      static_cast<int>(std::min_element(remoteness.begin(), remoteness.end()) - remoteness.begin());
  starts.assign(1, core);
  while (ends_.size() < std::min(kEnds, maxima.size())) {
    const PatchWays ways = patch_ways(graph_, starts, everywhere);
    const auto end = std::max_element(maxima.begin(), maxima.end(),
                                      [&](int a, int b) { return ways.distance[a] < ways.distance[b]; });
    if (!(ways.distance[*end] > 0)) break;
    ends_.push_back(*end);
    starts.push_back(*end);
  }
}

/// The first `size` patches on the ways from an end, with whatever they separate from the larger rest.
std::optional<Candidate> CutSearch::beyond(const PatchWays& ways, std::size_t size, double length,
                                           const Measured& from, const std::vector<bool>& inside) const {
  Candidate candidate;
  candidate.piece.assign(ways.order.begin(), ways.order.begin() + static_cast<std::ptrdiff_t>(size));
  std::vector<bool> rest = inside;
  for (const int i : candidate.piece) rest[i] = false;
  std::vector<std::vector<int>> groups = connected_groups(graph_, rest);
  if (groups.empty()) return std::nullopt;
  candidate.left = std::move(groups.front());
  for (std::size_t g = 1; g < groups.size(); ++g) {
    candidate.piece.insert(candidate.piece.end(), groups[g].begin(), groups[g].end());
  }
  const double area = area_of(graph_, candidate.piece), left = area_of(graph_, candidate.left);
  if (area < kLeastArea * area_ || area > kMostArea * (area + left)) return std::nullopt;
  candidate.piece_depth = depth_of(graph_, candidate.piece);
  candidate.left_depth = depth_of(graph_, candidate.left);
  const double gain = from.depth.total - candidate.piece_depth.total - candidate.left_depth.total;
  if (gain < kLeastGain * total_) return std::nullopt;
  candidate.score = gain * std::sqrt(std::sqrt(std::min(area, left)) / std::max(length, 1e-300));
  return candidate;
}

std::vector<Candidate> CutSearch::cuts_for(int end, const Measured& from,
                                           const std::vector<bool>& inside) const {
  const double area = area_of(graph_, from.patches);
  const PatchWays ways = patch_ways(graph_, {end}, inside);
  std::vector<bool> within(graph_.count(), false);
  double length = 0, covered = 0, shortest = std::numeric_limits<double>::infinity();
  std::size_t neck = 0, root = 0, through = 0;
  std::vector<double> lengths;
  for (std::size_t k = 0; k < ways.order.size(); ++k) {
    const int i = ways.order[k];
    within[i] = true;
    covered += graph_.area[i];
    for (int link = graph_.first[i]; link < graph_.first[i + 1]; ++link) {
      const int j = graph_.neighbour[link];
      if (inside[j]) length += within[j] ? -graph_.border[link] : graph_.border[link];
    }
    lengths.push_back(length);
    if (i == from.depth.deepest) through = k + 1;
    if (covered < kLeastArea * area_ || covered > kMostArea * area) continue;
    const double ratio = length / std::sqrt(std::min(covered, area - covered));
    if (ratio <= kRoot * shortest) root = k + 1;
    if (ratio >= shortest) continue;
    shortest = ratio;
    neck = k + 1;
  }
  std::vector<Candidate> cuts;
  for (const std::size_t size : {neck, root, through}) {
    if (size == 0 || size == ways.order.size()) continue;
    if (auto cut = beyond(ways, size, lengths[size - 1], from, inside)) cuts.push_back(std::move(*cut));
  }
  return cuts;
}

std::optional<Candidate> CutSearch::best_cut(const Measured& from) const {
  const std::vector<bool> inside = mask(from.patches);
  std::vector<std::vector<Candidate>> found(ends_.size());
  tbb::parallel_for(std::size_t{0}, ends_.size(), [&](std::size_t e) {
    if (inside[ends_[e]]) found[e] = cuts_for(ends_[e], from, inside);
  });
  std::optional<Candidate> best;
  for (std::vector<Candidate>& cuts : found) {
    for (Candidate& cut : cuts) {
      if (!best || cut.score > best->score) best = std::move(cut);
    }
  }
  return best;
}

/// Joins two pieces where that keeps the goal and makes them hardly worse. \return whether there were such
bool CutSearch::join_one() {
  for (std::size_t k = pieces_.size(); k-- > 1;) {
    for (std::size_t other = 0; other < k; ++other) {
      std::vector<int> joined = pieces_[other].patches;
      joined.insert(joined.end(), pieces_[k].patches.begin(), pieces_[k].patches.end());
      if (connected_groups(graph_, mask(joined)).size() > 1) continue;
      const Depth depth = depth_of(graph_, joined);
      const Depth &a = pieces_[other].depth, &b = pieces_[k].depth;
      if (depth.largest > std::max({goal_, a.largest, b.largest})) continue;
      if (depth.total - a.total - b.total > kLeastGain * total_) continue;
      pieces_[other] = {std::move(joined), depth};
      pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>(k));
      return true;
    }
  }
  return false;
}

void CutSearch::join_needless() {
  while (pieces_.size() > 1 && join_one()) continue;
}

/// The largest piece is 0, the others follow in the order of their cuts.
std::vector<int> CutSearch::numbered() const {
  const auto largest = std::max_element(pieces_.begin(), pieces_.end(), [&](const auto& a, const auto& b) {
    return area_of(graph_, a.patches) < area_of(graph_, b.patches);
  });
  std::vector<int> piece_of(graph_.count(), 0);
  int number = 0;
  for (const Measured& piece : pieces_) {
    if (&piece == &*largest) continue;
    ++number;
    for (const int i : piece.patches) piece_of[i] = number;
  }
  return piece_of;
}

}  // namespace

std::vector<int> search_cuts(const PatchGraph& graph, double goal, int most) {
  return CutSearch(graph, goal, most).pieces();
}

double largest_depth(const PatchGraph& graph, const std::vector<int>& patches) {
  return depth_of(graph, patches).largest;
}

}  // namespace partwise
