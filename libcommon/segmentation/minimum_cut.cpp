#include "segmentation/minimum_cut.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace partwise {
namespace {

/// Capacities are whole numbers: their sums are exact, so the cut does not depend on the order of terms.
using Capacity = std::int64_t;
constexpr double kResolution = 1e-9;  // of the largest cost

/// Maximal flow along shortest paths with blocked dead ends (Dinic 1970).
class Network {
 public:
  explicit Network(int node_count)
      : source_(node_count), sink_(node_count + 1), first_(node_count + 2, -1), level_(node_count + 2, -1) {}

  int source() const { return source_; }
  int sink() const { return sink_; }
  void connect(int from, int to, Capacity capacity) {
    if (capacity == 0) return;
    add_arc(from, to, capacity);
    add_arc(to, from, 0);
  }
  void saturate() {
    while (find_levels()) augment();
  }
  /// After saturate(): the sink can still be reached from `node`.
  bool reaches_sink(int node) const { return level_[node] >= 0; }

 private:
  struct Arc {
    int to;
    int next;  // of the same node, or -1
    Capacity left;
  };
  void add_arc(int from, int to, Capacity capacity) {
    arcs_.push_back({to, first_[from], capacity});
    first_[from] = static_cast<int>(arcs_.size()) - 1;
  }
  bool find_levels();
  void augment();
  void push_along(std::vector<int>& path);

  int source_;
  int sink_;
  std::vector<Arc> arcs_;  // 2 i and 2 i + 1 are each other's reverse
  std::vector<int> first_;
  std::vector<int> current_;
  std::vector<int> level_;  // arcs to the sink, or -1
};

/// Distances to the sink through arcs with capacity left; false when the source does not reach it.
bool Network::find_levels() {
  std::fill(level_.begin(), level_.end(), -1);
  level_[sink_] = 0;
  std::vector<int> queue{sink_};
  for (std::size_t i = 0; i < queue.size(); ++i) {
    for (int arc = first_[queue[i]]; arc >= 0; arc = arcs_[arc].next) {
      const int from = arcs_[arc].to;
      if (level_[from] >= 0 || arcs_[arc ^ 1].left == 0) continue;
      level_[from] = level_[queue[i]] + 1;
      queue.push_back(from);
    }
  }
  return level_[source_] >= 0;
}

/// Fills the path from source to sink; what remains of it leads to its first full arc.
void Network::push_along(std::vector<int>& path) {
  Capacity amount = arcs_[path.front()].left;
  for (const int arc : path) amount = std::min(amount, arcs_[arc].left);
  std::size_t full = path.size();
  for (std::size_t i = path.size(); i-- > 0;) {
    arcs_[path[i]].left -= amount;
    arcs_[path[i] ^ 1].left += amount;
    if (arcs_[path[i]].left == 0) full = i;
  }
  path.resize(full);
}

/// Sends flow along descending levels until every such path is blocked.
void Network::augment() {
  current_ = first_;
  std::vector<int> path;
  while (true) {
    const int node = path.empty() ? source_ : arcs_[path.back()].to;
    if (node == sink_) {
      push_along(path);
      continue;
    }
    int& arc = current_[node];
    while (arc >= 0 && !(arcs_[arc].left > 0 && level_[arcs_[arc].to] == level_[node] - 1)) {
      arc = arcs_[arc].next;
    }
    if (arc >= 0) {
      path.push_back(arc);
    } else if (path.empty()) {
      return;
    } else {
      level_[node] = -2;  // a dead end
      path.pop_back();
    }
  }
}

}  // namespace

BinaryCut::BinaryCut(int variable_count) : cost_if_set_(static_cast<std::size_t>(variable_count), 0.0) {}

void BinaryCut::add_pair_cost(int i, int j, double cost) {
  if (cost > 0) pairs_.push_back({i, j, cost});
}

std::vector<bool> BinaryCut::minimise() const {
  double largest = 0;
  for (const double cost : cost_if_set_) largest = std::max(largest, std::abs(cost));
  for (const Pair& pair : pairs_) largest = std::max(largest, pair.cost);
  auto whole = [&](double cost) -> Capacity { return std::llround(cost / (largest * kResolution)); };

  Network network(static_cast<int>(cost_if_set_.size()));  // x_i = 0 on the source's side
  for (std::size_t i = 0; i < cost_if_set_.size() && largest > 0; ++i) {
    const int node = static_cast<int>(i);
    if (cost_if_set_[i] > 0) network.connect(network.source(), node, whole(cost_if_set_[i]));
    if (cost_if_set_[i] < 0) network.connect(node, network.sink(), whole(-cost_if_set_[i]));
  }
  for (const Pair& pair : pairs_) network.connect(pair.i, pair.j, whole(pair.cost));
  network.saturate();
  std::vector<bool> set(cost_if_set_.size());
  for (std::size_t i = 0; i < set.size(); ++i) set[i] = network.reaches_sink(static_cast<int>(i));
  return set;
}

}  // namespace partwise
