#include "mapping/collapse_to_tetrahedron.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "error.h"

namespace partwise {
namespace {

/// Collapses everything down to a tetrahedron, cheapest first; the record is in the order of the collapses.
class Decimation {
  // Cost, vertex, neighbour it merges into. In single precision the mirrored edges of a symmetric shape cost
  // the same, and the vertices' order decides instead of rounding, which a turn of the model would change.
  using Entry = std::tuple<float, int, int>;

 public:
  Decimation(const TriMesh& mesh, RingMesh& rings)
      : mesh_(mesh),
        rings_(rings),
        scale_(1 / std::pow(mesh.diagonal(), 2)),
        queued_(mesh.vertex_count(), Entry{0, 0, -1}) {}

  std::vector<Collapse> run() {
    std::vector<Collapse> record;
    while (rings_.present_count() > 4) {
      if (queue_.empty()) enqueue_all();
      const auto [cost, u, v] = *queue_.begin();
      dequeue(u);
      if (!rings_.can_collapse(u, v)) {  // a collapse nearby has changed that
        enqueue(u);
        continue;
      }
      record.push_back({u, rings_.collapse(u, v)});
      for (const int neighbour : record.back().ring) enqueue(neighbour);
    }
    return record;
  }

 private:
  void enqueue_all() {
    for (int u = 0; u < mesh_.vertex_count(); ++u) enqueue(u);
    if (queue_.empty())
      throw InputError("the part cannot be collapsed: it is not a closed surface of genus 0");
  }

  void dequeue(int u) {
    if (std::get<2>(queued_[u]) >= 0) queue_.erase(queued_[u]);
    queued_[u] = {0, u, -1};
  }

  void enqueue(int u) {
    dequeue(u);
    Entry best{0, u, -1};
    for (const int v : rings_.ring(u)) {
      if (!rings_.can_collapse(u, v)) continue;
      const auto degree = static_cast<double>(rings_.ring(u).size());
      const double merged = static_cast<double>(rings_.ring(v).size()) + degree - 4;
      const double penalty = 1 + std::max(0.0, merged - 10);
      const auto cost =
          static_cast<float>(scale_ * (mesh_.point(u) - mesh_.point(v)).squaredNorm() * degree * penalty);
      if (std::get<2>(best) < 0 || cost < std::get<0>(best)) best = {cost, u, v};
    }
    if (std::get<2>(best) < 0) return;
    queued_[u] = best;
    queue_.insert(best);
  }

  const TriMesh& mesh_;
  RingMesh& rings_;
  const double scale_;  // keeps costs within the range of single precision
  std::set<Entry> queue_;
  std::vector<Entry> queued_;
};

}  // namespace

std::vector<Collapse> collapse_to_tetrahedron(const TriMesh& mesh, RingMesh& rings) {
  return Decimation(mesh, rings).run();
}

}  // namespace partwise
